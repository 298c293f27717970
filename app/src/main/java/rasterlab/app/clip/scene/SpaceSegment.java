package rasterlab.app.clip.scene;

/** A segment of space from a to b; any doubles, even NaN, which methods refuse. */
public record SpaceSegment(SpacePoint a, SpacePoint b) {
    static SpaceSegment of(double[] ends) {
        return new SpaceSegment(
                new SpacePoint(ends[0], ends[1], ends[2]),
                new SpacePoint(ends[3], ends[4], ends[5]));
    }

    public double[] ends() {
        return new double[] {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    }

    public SpacePoint end(int end) {
        return end == 0 ? a : b;
    }

    SpaceSegment moved(int end, SpacePoint to) {
        return end == 0 ? new SpaceSegment(to, b) : new SpaceSegment(a, to);
    }
}
