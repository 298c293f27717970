package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.engine.range.Finite;

/**
 * Polygons and an eye: an input of topic {@code depth-order}.
 *
 * @param polygons x, y, z of the corners of each, flat and convex, of some area
 * @param eye x, y, z, finite
 */
public record Sight(double[][] polygons, double[] eye) {
    public Sight {
        polygons = Arrays.stream(polygons).map(double[]::clone).toArray(double[][]::new);
        eye = eye.clone();
        if (eye.length != 3)
            throw new IllegalArgumentException("eye needs 3 numbers, got " + Arrays.toString(eye));
        Finite.require("eye coordinate", eye);
        for (int k = 0; k < polygons.length; k++) requireCorners(k, polygons[k]);
    }

    private static void requireCorners(int polygon, double[] xyz) {
        if (xyz.length % 3 != 0 || xyz.length < 9)
            throw new IllegalArgumentException(
                    "polygon %d needs at least 3 corners of 3 numbers each, got %d numbers"
                            .formatted(polygon, xyz.length));
        for (int i = 0; i < xyz.length; i++)
            if (!Double.isFinite(xyz[i]))
                throw new IllegalArgumentException(
                        "polygon %d, corner %d: %s must be finite, got %s"
                                .formatted(polygon, i / 3, "xyz".charAt(i % 3), xyz[i]));
    }

    int size() {
        return polygons.length;
    }

    /** This, each coordinate times {@code factor}. */
    Sight scaled(double factor) {
        return new Sight(
                Arrays.stream(polygons).map(xyz -> times(xyz, factor)).toArray(double[][]::new),
                times(eye, factor));
    }

    private static double[] times(double[] values, double factor) {
        return Arrays.stream(values).map(value -> factor * value).toArray();
    }

    /** The e for which all coordinates times 2⁻ᵉ are at most ¼ in size. */
    int exponent() {
        return Math.getExponent(Math.max(largest(), Double.MIN_NORMAL)) + 3;
    }

    /** The largest coordinate in size, of corners and eye. */
    double largest() {
        double largest = 0;
        for (double value : eye) largest = Math.max(largest, Math.abs(value));
        for (double[] xyz : polygons)
            for (double value : xyz) largest = Math.max(largest, Math.abs(value));
        return largest;
    }

    /**
     * The polygons as seen from the eye.
     *
     * @throws IllegalArgumentException naming the first that is not flat, convex and of some area
     */
    List<Facet> facets() {
        int by = -exponent();
        var facets = new ArrayList<Facet>();
        for (int k = 0; k < polygons.length; k++)
            facets.add(Facet.whole(k, polygons[k], seen(k, by)));
        return facets;
    }

    /** The corners of polygon k less the eye, times 2 to the power of {@code by}. */
    double[] seen(int k, int by) {
        var seen = new double[polygons[k].length];
        for (int i = 0; i < seen.length; i++)
            seen[i] = Math.scalb(polygons[k][i], by) - Math.scalb(eye[i % 3], by);
        return seen;
    }

    @Override
    public String toString() {
        return polygons.length + " polygons seen from " + Arrays.toString(eye);
    }
}
