package rasterlab.engine.transform.chain;

import java.util.Arrays;

/**
 * One task: points and the matrices they go through.
 *
 * @param dimension of a point, 2 or 3
 * @param matrices applied left to right, each with (dimension + 1)² cells row by row
 * @param points one after the other
 */
public record Chain(int dimension, double[][] matrices, double[] points) {
    public Chain {
        if (dimension != 2 && dimension != 3)
            throw new IllegalArgumentException("dimension must be 2 or 3, got " + dimension);
        matrices = Arrays.stream(matrices).map(double[]::clone).toArray(double[][]::new);
        points = points.clone();
    }

    int size() {
        return points.length / dimension;
    }
}
