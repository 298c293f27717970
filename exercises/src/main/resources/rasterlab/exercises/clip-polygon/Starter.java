import rasterlab.contract.PolygonClipper;
import rasterlab.contract.PolygonSink;

/** Clips a polygon by a convex window. So far it leaves nothing of any polygon. */
public class MyPolygonClip implements PolygonClipper {
    @Override
    public void clip(double[] window, double[] subject, PolygonSink out) {}
}
