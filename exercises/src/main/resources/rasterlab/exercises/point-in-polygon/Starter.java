import rasterlab.contract.PointInPolygon;

/** Tells whether a point lies in a polygon. So far it is never inside. */
public class MyPolygon implements PointInPolygon {
    @Override
    public boolean contains(double[] polygonX, double[] polygonY, double x, double y) {
        return false;
    }
}
