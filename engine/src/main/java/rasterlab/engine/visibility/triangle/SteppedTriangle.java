package rasterlab.engine.visibility.triangle;

import rasterlab.contract.DepthTriangleFiller;

/** A filler whose pixels can be gone through one after the other. */
interface SteppedTriangle extends DepthTriangleFiller {
    RowsWalk walk(double[] x, double[] y, double[] z, int width, int height);
}
