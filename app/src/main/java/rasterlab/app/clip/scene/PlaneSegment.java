package rasterlab.app.clip.scene;

/** A segment of the plane from a to b; any doubles, even NaN, which methods refuse. */
public record PlaneSegment(ClipPoint a, ClipPoint b) {
    public static PlaneSegment of(double[] ends) {
        return new PlaneSegment(new ClipPoint(ends[0], ends[1]), new ClipPoint(ends[2], ends[3]));
    }

    public double[] ends() {
        return new double[] {a.x(), a.y(), b.x(), b.y()};
    }

    public ClipPoint end(int end) {
        return end == 0 ? a : b;
    }

    PlaneSegment moved(int end, ClipPoint to) {
        return end == 0 ? new PlaneSegment(to, b) : new PlaneSegment(a, to);
    }
}
