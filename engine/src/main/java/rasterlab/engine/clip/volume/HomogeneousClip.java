package rasterlab.engine.clip.volume;

/**
 * Clipping in homogeneous coordinates, after the matrix M_p and before the division.
 *
 * <p>As rows, [x y z 1]·M_p = [X Y Z W] with X = x, Y = y, Z = (z − zmin)/(1 − zmin), W = z; the
 * division by W makes the pyramid a box −1..1, −1..1, 0..1. Dividing first would fold what is
 * behind the eye (W &lt; 0) to the front and has no answer at the eye (W = 0). So the box's planes
 * are taken before: W − X, W + X, W − Y, W + Y, Z, W − Z are at least 0 within. Each is linear
 * along the segment, b0 at one end and b1 at the other, and 0 at t = b0/(b0 − b1). Since M_p is
 * linear, the same t gives the point in the pyramid.
 *
 * <p>W − Z = zmin·(1 − z)/(1 − zmin) is a small difference of large numbers where zmin is small,
 * the loss that depth buffers know. Its rounding, 3·u·|Z| from Z's three operations and u·(|W| +
 * |Z|) from the difference (u = 2⁻⁵³), so less than 6·u·(|W| + |Z|), is followed: where it might
 * change a sign or move an end by more than {@value #MOST_SHIFT}, the segment is handed over. So
 * each t errs by less than that, and where enter and leave are more than {@value #SURE} apart, over
 * twice as much, their order is the exact one; nearer, it is handed over too.
 *
 * <p>Source: J. F. Blinn, M. E. Newell, Clipping using homogeneous coordinates, SIGGRAPH 1978, pp.
 * 245–251; the matrix after A. V. Kazantsev, Foundations of computer graphics for programmers,
 * Kazan, 2005, ch. 5.
 */
public final class HomogeneousClip implements SteppedVolumeClipper {
    private static final double MOST_SHIFT = 0x1p-42;
    private static final double SURE = 0x1p-38;
    private static final double ROUNDING = 6 * 0x1p-53;
    private static final String[] PLANES = {"X = W", "X = -W", "Y = W", "Y = -W", "Z = 0", "Z = W"};

    @Override
    public VolumeWalk walk(
            double zmin, double x0, double y0, double z0, double x1, double y1, double z1) {
        return new Walk(zmin, x0, y0, z0, x1, y1, z1);
    }

    @Override
    public String decisionFormula() {
        return "t = b0/(b0 − b1), b = W − X, W + X, W − Y, W + Y, Z, W − Z";
    }

    /** X, Y, Z, W of [x y z 1]·M_p. */
    static double[] canonical(double zmin, double x, double y, double z) {
        return new double[] {x, y, (z - zmin) / (1 - zmin), z};
    }

    private static final class Walk extends PyramidWalk {
        private final double[] bordersFrom;
        private final double[] bordersTo;
        private int plane = -1;
        private double t = Double.NaN;

        Walk(double zmin, double x0, double y0, double z0, double x1, double y1, double z1) {
            super(zmin, x0, y0, z0, x1, y1, z1);
            bordersFrom = borders(x0, y0, z0);
            bordersTo = borders(x1, y1, z1);
        }

        /** The six border coordinates of a point, for which M_p divides once. */
        private double[] borders(double eyeX, double eyeY, double eyeZ) {
            double[] clip = canonical(zmin, eyeX, eyeY, eyeZ);
            divisions++;
            double clipX = clip[0];
            double clipY = clip[1];
            double clipZ = clip[2];
            double clipW = clip[3];
            return new double[] {
                clipW - clipX, clipW + clipX, clipW - clipY, clipW + clipY, clipZ, clipW - clipZ
            };
        }

        @Override
        public boolean advance() {
            if (plane == 5 || enter > leave || unsure()) return false;
            cut(++plane);
            return true;
        }

        private void cut(int border) {
            double b0 = bordersFrom[border];
            double b1 = bordersTo[border];
            t = Double.NaN;
            if (border == 5 && hidden(b0, b1)) handOver();
            if (b0 < 0 && b1 < 0) leave = Double.NEGATIVE_INFINITY;
            if (b0 < 0 == b1 < 0) return;
            t = b0 / (b0 - b1);
            divisions++;
            if (b0 < 0) enter = Math.max(enter, t);
            else leave = Math.min(leave, t);
            if (Math.abs(leave - enter) <= SURE) handOver();
        }

        /** Whether the rounding of W − Z may change a sign, or shift the crossing too far. */
        private boolean hidden(double b0, double b1) {
            double e0 = ROUNDING * (Math.abs(eyeZ0) + Math.abs(bordersFrom[4]));
            double e1 = ROUNDING * (Math.abs(eyeZ1) + Math.abs(bordersTo[4]));
            if (Math.abs(b0) <= e0 || Math.abs(b1) <= e1) return true;
            return b0 < 0 != b1 < 0
                    && 2 * (e0 + e1) * Math.max(reach(), 1) > MOST_SHIFT * Math.abs(b0 - b1);
        }

        @Override
        boolean kept() {
            return enter <= leave;
        }

        @Override
        public String at() {
            return plane < 0 ? "" : PLANES[plane];
        }

        @Override
        public double decision() {
            return t;
        }
    }
}
