package rasterlab.engine.visibility.faces;

import java.util.Arrays;
import rasterlab.engine.geometry.VertexNumber;
import rasterlab.engine.range.Finite;

/**
 * A body and an eye: an input of topic {@code visible-faces}.
 *
 * @param xyz x, y, z of each vertex, finite
 * @param faces vertex numbers of each face, at least three
 * @param eye x, y, z, finite
 * @param inside x, y, z of an inner point, finite; or no numbers
 */
public record Body(double[] xyz, int[][] faces, double[] eye, double[] inside) {
    private static final double[] UNKNOWN = {};

    public Body {
        xyz = xyz.clone();
        faces = Arrays.stream(faces).map(int[]::clone).toArray(int[][]::new);
        eye = eye.clone();
        inside = inside.clone();
        requireVertices(xyz);
        for (int f = 0; f < faces.length; f++) requireFace(f, faces[f], xyz.length / 3);
        requirePoint("eye", eye);
        if (inside.length > 0) requirePoint("inside", inside);
    }

    /** A body of which no inner point is known. */
    static Body seenFrom(double[] eye, double[] xyz, int[]... faces) {
        return new Body(xyz, faces, eye, UNKNOWN);
    }

    Body withInside(double... point) {
        return new Body(xyz, faces, eye, point);
    }

    /** This body, its eye and its inner point, each coordinate times {@code factor}. */
    Body scaled(double factor) {
        return new Body(times(xyz, factor), faces, times(eye, factor), times(inside, factor));
    }

    private static double[] times(double[] values, double factor) {
        return Arrays.stream(values).map(value -> factor * value).toArray();
    }

    int faceCount() {
        return faces.length;
    }

    /** The inner point, or the mean of the vertices where none is given. */
    public double[] insideOrMean() {
        if (inside.length > 0) return inside.clone();
        var mean = new double[3];
        int vertices = xyz.length / 3;
        // Each term is divided first: the sum of the largest doubles would overflow.
        for (int i = 0; i < xyz.length; i++) mean[i % 3] += xyz[i] / vertices;
        // Where all numbers are the largest double, rounding leads beyond it.
        for (int i = 0; i < 3; i++)
            mean[i] = Math.max(-Double.MAX_VALUE, Math.min(Double.MAX_VALUE, mean[i]));
        return mean;
    }

    private static void requireVertices(double[] xyz) {
        if (xyz.length % 3 != 0)
            throw new IllegalArgumentException(
                    "vertices must have 3 numbers each, got " + xyz.length + " in all");
        for (int i = 0; i < xyz.length; i++)
            if (!Double.isFinite(xyz[i]))
                throw new IllegalArgumentException(
                        "vertex %d: %s must be finite, got %s"
                                .formatted(i / 3, "xyz".charAt(i % 3), xyz[i]));
    }

    private static void requireFace(int number, int[] face, int vertices) {
        if (face.length < 3)
            throw new IllegalArgumentException(
                    "face %d needs at least 3 corners, got %d".formatted(number, face.length));
        for (int corner : face)
            if (!VertexNumber.exists(corner, vertices))
                throw new IllegalArgumentException(
                        VertexNumber.refusal("face " + number + ": corner", corner, vertices));
    }

    private static void requirePoint(String name, double[] point) {
        if (point.length != 3)
            throw new IllegalArgumentException(
                    name + " needs 3 numbers, got " + Arrays.toString(point));
        Finite.require(name + " coordinate", point);
    }

    @Override
    public String toString() {
        return "%d faces, eye %s, inside %s"
                .formatted(faces.length, Arrays.toString(eye), Arrays.toString(inside));
    }
}
