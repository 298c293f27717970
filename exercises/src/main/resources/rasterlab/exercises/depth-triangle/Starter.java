import rasterlab.contract.DepthTriangleFiller;

/** Fills a triangle into a depth buffer. So far it writes nothing. */
public class MyDepthTriangle implements DepthTriangleFiller {
    @Override
    public void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {}
}
