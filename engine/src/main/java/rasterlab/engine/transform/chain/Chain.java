package rasterlab.engine.transform.chain;

import java.util.Arrays;

/**
 * One task: points and the matrices they go through.
 *
 * @param dimension of a point, 2 or 3
 * @param matrices applied left to right, each with (dimension + 1)² cells row by row
 * @param points one after the other
 * @param h the homogeneous coordinate of each point, 1 for a plain one and 0 at infinity
 */
public record Chain(int dimension, double[][] matrices, double[] points, double[] h) {
    public Chain {
        if (dimension != 2 && dimension != 3)
            throw new IllegalArgumentException("dimension must be 2 or 3, got " + dimension);
        matrices = Arrays.stream(matrices).map(double[]::clone).toArray(double[][]::new);
        points = points.clone();
        h = h.clone();
    }

    /** A chain for plain points, whose homogeneous coordinate is 1. */
    public Chain(int dimension, double[][] matrices, double[] points) {
        this(dimension, matrices, points, ones(points.length / Math.max(1, dimension)));
    }

    private static double[] ones(int count) {
        var ones = new double[count];
        Arrays.fill(ones, 1);
        return ones;
    }

    int size() {
        return points.length / dimension;
    }
}
