package rasterlab.app.polygon.figure;

/** A place in the plane: y up where points are judged and polygons cut, y down on pixels. */
public record PolygonPoint(double x, double y) {
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y);
    }

    /** The nearest place with whole coordinates. */
    PolygonPoint whole() {
        return new PolygonPoint(Math.rint(x), Math.rint(y));
    }
}
