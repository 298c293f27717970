package rasterlab.app.clip;

/** A segment of the plane from a to b; any doubles, even NaN, which methods refuse. */
public record PlaneSegment(Place a, Place b) {
    static PlaneSegment of(double[] ends) {
        return new PlaneSegment(new Place(ends[0], ends[1]), new Place(ends[2], ends[3]));
    }

    double[] ends() {
        return new double[] {a.x(), a.y(), b.x(), b.y()};
    }

    Place end(int end) {
        return end == 0 ? a : b;
    }

    PlaneSegment moved(int end, Place to) {
        return end == 0 ? new PlaneSegment(to, b) : new PlaneSegment(a, to);
    }
}
