package rasterlab.engine.visibility.triangle;

import rasterlab.contract.DepthTriangleFiller;

/**
 * Looks at every centre in the box around the triangle; its weights tell whether it belongs to the
 * triangle, and its depth.
 *
 * <p>Source: J. Pineda, A parallel algorithm for polygon rasterization, SIGGRAPH 1988, pp. 17–20.
 */
final class WeightsTriangle implements DepthTriangleFiller {
    @Override
    public void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {
        var plane = new TrianglePlane(x, y, z);
        int top = first(y);
        int bottom = last(y, height);
        int right = last(x, width);
        for (int row = top; row <= bottom; row++)
            for (int column = first(x); column <= right; column++) {
                if (!plane.owns(column, row)) continue;
                double depth = plane.depth(column, row);
                if (!(depth < depths[row * width + column])) continue;
                depths[row * width + column] = depth;
                shown[row * width + column] = number;
            }
    }

    private static int first(double[] corners) {
        return (int) Math.max(0, Math.ceil(Math.min(corners[0], Math.min(corners[1], corners[2]))));
    }

    private static int last(double[] corners, int size) {
        double most = Math.max(corners[0], Math.max(corners[1], corners[2]));
        return (int) Math.min(size - 1, Math.floor(most));
    }
}
