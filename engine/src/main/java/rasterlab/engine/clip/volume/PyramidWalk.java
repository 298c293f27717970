package rasterlab.engine.clip.volume;

import rasterlab.contract.SpaceSegmentSink;

/**
 * Base of the walks of the right methods: the segment in eye coordinates, the part not yet cut off,
 * enter ≤ t ≤ leave, and whether doubles are good enough.
 *
 * <p>Up to {@value #LONGEST} times the volume's depth, a t that errs by 2⁻⁵¹ moves an end by less
 * than 5·10⁻¹³; longer segments, and numbers that are not finite, are {@link #unsure} from the
 * start.
 */
abstract class PyramidWalk implements VolumeWalk {
    private static final double LONGEST = 1024;

    final double zmin;
    final double eyeX0;
    final double eyeY0;
    final double eyeZ0;
    final double eyeX1;
    final double eyeY1;
    final double eyeZ1;
    final double eyeDx;
    final double eyeDy;
    final double eyeDz;
    double enter;
    double leave = 1;
    int divisions;
    private boolean unsure;

    PyramidWalk(
            double zmin,
            double eyeX0,
            double eyeY0,
            double eyeZ0,
            double eyeX1,
            double eyeY1,
            double eyeZ1) {
        this.zmin = zmin;
        this.eyeX0 = eyeX0;
        this.eyeY0 = eyeY0;
        this.eyeZ0 = eyeZ0;
        this.eyeX1 = eyeX1;
        this.eyeY1 = eyeY1;
        this.eyeZ1 = eyeZ1;
        eyeDx = eyeX1 - eyeX0;
        eyeDy = eyeY1 - eyeY0;
        eyeDz = eyeZ1 - eyeZ0;
        // Written so that NaN makes it false.
        boolean sure = reach() <= LONGEST && zmin > 0 && zmin < 1;
        unsure = !sure;
    }

    /** The largest change of a coordinate along the segment. */
    final double reach() {
        return Math.max(Math.max(Math.abs(eyeDx), Math.abs(eyeDy)), Math.abs(eyeDz));
    }

    /** Whether something is left, where the walk is sure. */
    abstract boolean kept();

    @Override
    public final boolean unsure() {
        return unsure;
    }

    final void handOver() {
        unsure = true;
    }

    @Override
    public final int divisions() {
        return divisions;
    }

    @Override
    public final void send(SpaceSegmentSink out) {
        if (unsure) UnroundedVolume.clip(zmin, eyeX0, eyeY0, eyeZ0, eyeX1, eyeY1, eyeZ1, out);
        else if (kept()) sendPart(out);
    }

    @Override
    public final void piece(SpaceSegmentSink out) {
        double back = 1 - leave;
        out.segment(
                eyeX0 + enter * eyeDx,
                eyeY0 + enter * eyeDy,
                eyeZ0 + enter * eyeDz,
                eyeX1 - back * eyeDx,
                eyeY1 - back * eyeDy,
                eyeZ1 - back * eyeDz);
    }

    /**
     * Sends the part that is left, moved into the range that the planes allow; an end stays as it
     * is where its t is 0 or 1.
     */
    private void sendPart(SpaceSegmentSink out) {
        double back = 1 - leave;
        double fromZ = within(eyeZ0 + enter * eyeDz);
        double toZ = within(eyeZ1 - back * eyeDz);
        out.segment(
                within(eyeX0 + enter * eyeDx, fromZ),
                within(eyeY0 + enter * eyeDy, fromZ),
                fromZ,
                within(eyeX1 - back * eyeDx, toZ),
                within(eyeY1 - back * eyeDy, toZ),
                toZ);
    }

    private double within(double z) {
        return Math.max(zmin, Math.min(1, z));
    }

    private static double within(double coordinate, double z) {
        return Math.max(-z, Math.min(z, coordinate));
    }
}
