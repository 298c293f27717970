package rasterlab.engine.visibility.hidden;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.SphericalView;

/**
 * Faces placed by eye, one after the other: to the right and up on the picture, in world units, and
 * away from the eye.
 */
final class Quads {
    static final double RHO = 500;

    /** World y is to the right, z up, x to the eye. */
    static final SphericalView FROM_X = new SphericalView(0, Math.PI / 2, RHO);

    private final List<double[]> faces = new ArrayList<>();

    /**
     * @param corners right, up, and depth from the eye, of each
     */
    Quads add(double... corners) {
        faces.add(corners);
        return this;
    }

    /** A square across the line of sight, from its middle {@code half} to each side. */
    Quads square(double right, double up, double depth, double half) {
        return add(
                right - half,
                up - half,
                depth,
                right + half,
                up - half,
                depth,
                right + half,
                up + half,
                depth,
                right - half,
                up + half,
                depth);
    }

    Mesh mesh() {
        int corners = faces.stream().mapToInt(face -> face.length / 3).sum();
        var xyz = new double[3 * corners];
        var numbers = new int[faces.size()][];
        int at = 0;
        for (int f = 0; f < numbers.length; f++) {
            double[] face = faces.get(f);
            numbers[f] = new int[face.length / 3];
            for (int k = 0; k < numbers[f].length; k++, at++) {
                numbers[f][k] = at;
                xyz[3 * at] = RHO - face[3 * k + 2];
                xyz[3 * at + 1] = face[3 * k];
                xyz[3 * at + 2] = face[3 * k + 1];
            }
        }
        return new Mesh(xyz, numbers);
    }
}
