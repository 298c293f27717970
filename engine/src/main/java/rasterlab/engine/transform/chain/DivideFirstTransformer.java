package rasterlab.engine.transform.chain;

import rasterlab.contract.PointTransformer;

/**
 * Normal coordinates after every matrix, as the course prints them: {@code [X/H Y/H Z/H 1]}, and H
 * is 1 again.
 *
 * <p>The picture is the same as long as every H is above 0. A point behind the eye is drawn as if
 * it stood before it, since the sign of H, by which it could be clipped, is divided away; at the
 * eye, and for a point at infinity, the division is by 0.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "homogeneous
 * coordinates" and "perspective transformations", where no H is looked at before the division.
 */
final class DivideFirstTransformer implements PointTransformer {
    @Override
    public void transform(int dimension, double[][] matrices, double[] points, double[] h) {
        ChainCheck.require(dimension, matrices, points, h);
        var image = new double[dimension + 1];
        for (int i = 0; i < h.length; i++) {
            for (int j = 0; j < dimension; j++) points[i * dimension + j] /= h[i];
            for (double[] matrix : matrices) {
                DoubleTransformer.image(matrix, points, i * dimension, 1, image);
                for (int j = 0; j < dimension; j++)
                    points[i * dimension + j] = image[j] / image[dimension];
            }
            h[i] = 1;
        }
    }
}
