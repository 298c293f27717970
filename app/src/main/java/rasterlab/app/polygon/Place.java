package rasterlab.app.polygon;

/** A place in the plane: y up where points are judged and polygons cut, y down on pixels. */
public record Place(double x, double y) {
    boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y);
    }

    /** The nearest place with whole coordinates. */
    Place whole() {
        return new Place(Math.rint(x), Math.rint(y));
    }
}
