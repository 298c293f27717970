import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;

/** Puts polygons in the order in which to paint them. So far it paints none. */
public class MyOrder implements DepthOrder {
    @Override
    public void order(double[][] polygons, double[] eye, PieceSink out) {}
}
