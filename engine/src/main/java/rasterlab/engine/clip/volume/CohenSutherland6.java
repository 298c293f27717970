package rasterlab.engine.clip.volume;

/**
 * A code of six bits for each end tells which planes of the pyramid it lies beyond; only those are
 * cut at.
 *
 * <p>Bits 1 to 6: y &gt; z, y &lt; −z, x &gt; z, x &lt; −z, z &gt; 1, z &lt; zmin. Nothing is left
 * where the codes share a bit, all is left where both are 0. A plane whose bit one code has is met
 * at t = d0/(d0 − d1), d being the signed distances z − y, z + y, z − x, z + x, 1 − z, z − zmin of
 * the ends, above 0 within. Each is one difference of doubles: its sign is exact, and t errs by
 * less than 2⁻⁵¹. An end at the eye has bit 6 only; behind it, where z &lt; −z, every y is above z
 * or below −z or both, and so is every x, which gives it bits of other planes as well.
 *
 * <p>It ends because each plane is cut at once. enter and leave err by less than 2⁻⁵¹ each, so
 * where they are more than {@value #SURE} apart their order is the exact one; nearer, it is handed
 * over.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 5;
 * W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics, McGraw-Hill, 1973.
 */
public final class CohenSutherland6 implements SteppedVolumeClipper {
    private static final double SURE = 0x1p-48;
    private static final String[] PLANES = {
        "y = z", "y = -z", "x = z", "x = -z", "z = 1", "z = zmin"
    };

    @Override
    public VolumeWalk walk(
            double zmin, double x0, double y0, double z0, double x1, double y1, double z1) {
        return new Walk(zmin, x0, y0, z0, x1, y1, z1);
    }

    @Override
    public String decisionFormula() {
        return "t = d0/(d0 − d1), d the signed distance from the plane";
    }

    /** The six bits of a point, bit 1 being the lowest. */
    public static int code(double zmin, double x, double y, double z) {
        int code = 0;
        for (int plane = 0; plane < PLANES.length; plane++)
            if (distance(plane, zmin, x, y, z) < 0) code |= 1 << plane;
        return code;
    }

    private static double distance(int plane, double zmin, double x, double y, double z) {
        return switch (plane) {
            case 0 -> z - y;
            case 1 -> z + y;
            case 2 -> z - x;
            case 3 -> z + x;
            case 4 -> 1 - z;
            default -> z - zmin;
        };
    }

    private static final class Walk extends PyramidWalk {
        private final int fromCode;
        private final int toCode;
        private int open;
        private int plane = -1;
        private double t = Double.NaN;

        Walk(double zmin, double x0, double y0, double z0, double x1, double y1, double z1) {
            super(zmin, x0, y0, z0, x1, y1, z1);
            fromCode = code(zmin, x0, y0, z0);
            toCode = code(zmin, x1, y1, z1);
            open = (fromCode & toCode) != 0 ? 0 : fromCode | toCode;
        }

        @Override
        public boolean advance() {
            if (open == 0 || enter > leave || unsure()) return false;
            plane = Integer.numberOfTrailingZeros(open);
            open &= open - 1;
            double d0 = distance(plane, zmin, eyeX0, eyeY0, eyeZ0);
            double d1 = distance(plane, zmin, eyeX1, eyeY1, eyeZ1);
            t = d0 / (d0 - d1);
            divisions++;
            if (d0 < 0) enter = Math.max(enter, t);
            else leave = Math.min(leave, t);
            if (Math.abs(leave - enter) <= SURE) handOver();
            return true;
        }

        @Override
        boolean kept() {
            return (fromCode & toCode) == 0 && enter <= leave;
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
