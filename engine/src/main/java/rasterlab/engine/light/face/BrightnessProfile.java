package rasterlab.engine.light.face;

import java.util.List;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

/**
 * Brightness along a line across neighbouring faces, and what the eye makes Mach bands of: steps
 * where faces meet, and corners of the curve.
 *
 * @param perFace samples of each face, from edge to edge: the last one of a face and the first of
 *     the next stand on the same edge
 * @param brightness 0 to 1, face after face; the mean of red, green and blue
 */
public record BrightnessProfile(int perFace, double[] brightness) {
    /**
     * Shades a line from the first to the second corner of each face.
     *
     * @param faces neighbours: the second corner of one is the first of the next
     * @param perFace at least 3
     */
    public static BrightnessProfile along(FaceShader method, List<LitFace> faces, int perFace) {
        if (perFace < 3)
            throw new IllegalArgumentException("perFace must be at least 3, got " + perFace);
        var weights = new double[3 * perFace];
        for (int i = 0; i < perFace; i++) {
            weights[3 * i + 1] = i / (perFace - 1.0);
            weights[3 * i] = 1 - weights[3 * i + 1];
        }
        var brightness = new double[perFace * faces.size()];
        int at = 0;
        for (LitFace face : faces) {
            double[] rgb = method.shade(face, weights);
            for (int i = 0; i < rgb.length; i += 3)
                brightness[at++] = (rgb[i] + rgb[i + 1] + rgb[i + 2]) / 3;
        }
        return new BrightnessProfile(perFace, brightness);
    }

    /** The largest difference of two faces on their common edge: what flat shading shows. */
    public double largestStep() {
        double largest = 0;
        for (int at = perFace; at < brightness.length; at += perFace)
            largest = Math.max(largest, Math.abs(brightness[at] - brightness[at - 1]));
        return largest;
    }

    /**
     * The largest change of slope at an edge, in brightness per face: what is left of the bands by
     * Gouraud's shading.
     */
    public double largestKink() {
        double largest = 0;
        for (int at = perFace; at + 1 < brightness.length; at += perFace) {
            double before = brightness[at - 1] - brightness[at - 2];
            double after = brightness[at + 1] - brightness[at];
            largest = Math.max(largest, Math.abs(after - before) * (perFace - 1));
        }
        return largest;
    }
}
