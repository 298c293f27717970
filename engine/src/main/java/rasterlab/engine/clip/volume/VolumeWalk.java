package rasterlab.engine.clip.volume;

import rasterlab.contract.SpaceSegmentSink;

/**
 * A segment on its way through the view volume, one plane per step.
 *
 * <p>Drain it with {@code while (walk.advance())}, then {@link #send} what is left: enter ≤ t ≤
 * leave. Up to {@value #LONGEST} times the volume's depth, a t that errs by 2⁻⁵¹ moves an end by
 * less than 5·10⁻¹³; longer segments, and numbers that are not finite, are {@link #unsure} from the
 * start.
 */
public abstract class VolumeWalk {
    private static final double LONGEST = 1024;

    final double zmin;
    final double x0;
    final double y0;
    final double z0;
    final double x1;
    final double y1;
    final double z1;
    final double dx;
    final double dy;
    final double dz;
    double enter;
    double leave = 1;
    int divisions;
    private boolean unsure;

    VolumeWalk(double zmin, double x0, double y0, double z0, double x1, double y1, double z1) {
        this.zmin = zmin;
        this.x0 = x0;
        this.y0 = y0;
        this.z0 = z0;
        this.x1 = x1;
        this.y1 = y1;
        this.z1 = z1;
        dx = x1 - x0;
        dy = y1 - y0;
        dz = z1 - z0;
        // Written so that NaN makes it false.
        boolean sure = reach() <= LONGEST && zmin > 0 && zmin < 1;
        unsure = !sure;
    }

    /** The largest change of a coordinate along the segment. */
    final double reach() {
        return Math.max(Math.max(Math.abs(dx), Math.abs(dy)), Math.abs(dz));
    }

    /** Makes the next step; false when there is none, and then again each time. */
    public abstract boolean advance();

    /** The plane of the last step. */
    public abstract String at();

    /** The t of the last step, not a number where the plane is not met. */
    public abstract double decision();

    /** Whether something is left, where the walk is sure. */
    abstract boolean kept();

    /** Whether doubles cannot decide, so that {@link #send} computes without rounding. */
    public final boolean unsure() {
        return unsure;
    }

    final void handOver() {
        unsure = true;
    }

    /** Divisions of doubles made so far. */
    public final int divisions() {
        return divisions;
    }

    /** Sends what is left of the segment, if anything, once {@link #advance} has returned false. */
    public final void send(SpaceSegmentSink out) {
        if (unsure) UnroundedVolume.clip(zmin, x0, y0, z0, x1, y1, z1, out);
        else if (kept()) piece(out);
    }

    /**
     * Sends the part not yet cut off, moved into the range that the planes allow; an end stays as
     * it is where its t is 0 or 1.
     */
    public final void piece(SpaceSegmentSink out) {
        double back = 1 - leave;
        double fromZ = within(z0 + enter * dz);
        double toZ = within(z1 - back * dz);
        out.segment(
                within(x0 + enter * dx, fromZ),
                within(y0 + enter * dy, fromZ),
                fromZ,
                within(x1 - back * dx, toZ),
                within(y1 - back * dy, toZ),
                toZ);
    }

    private double within(double z) {
        return Math.max(zmin, Math.min(1, z));
    }

    private static double within(double coordinate, double z) {
        return Math.max(-z, Math.min(z, coordinate));
    }
}
