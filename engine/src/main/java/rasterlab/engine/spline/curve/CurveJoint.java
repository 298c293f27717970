package rasterlab.engine.spline.curve;

/**
 * How smoothly one piece of a curve goes over into the next.
 *
 * <p>Differences up to {@value #SAME} of the numbers' size are taken for rounding. Source of the
 * kinds: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and
 * Practice, 1990, chapter 11.
 *
 * @param before the end of one piece
 * @param after the start of the next
 */
public record CurveJoint(CurvePlace before, CurvePlace after) {
    private static final double SAME = 1e-9;

    /**
     * How two pieces join, from a gap to the same second derivative, each kind including those
     * before it.
     */
    public enum Continuity {
        /** The pieces do not touch. */
        GAP,
        /** The pieces touch. */
        C0,
        /** The direction goes on, the speed may jump. */
        G1,
        /** The derivative goes on. */
        C1,
        /** The second derivative goes on too. */
        C2
    }

    public Continuity kind() {
        double size =
                Math.max(Math.hypot(before.x(), before.y()), Math.hypot(after.x(), after.y()));
        double turn = turnRadians();
        if (gap() > SAME * Math.max(size, Double.MIN_NORMAL)) return Continuity.GAP;
        if (!(turn <= SAME)) return Continuity.C0;
        double jump = Math.hypot(after.dx() - before.dx(), after.dy() - before.dy());
        if (jump > SAME * Math.max(before.speed(), after.speed())) return Continuity.G1;
        double bend = Math.max(bend(before), bend(after));
        double bendJump = Math.hypot(after.ddx() - before.ddx(), after.ddy() - before.ddy());
        return bendJump > SAME * Math.max(bend, before.speed()) ? Continuity.C1 : Continuity.C2;
    }

    /** Pixels between the pieces. */
    public double gap() {
        return Math.hypot(after.x() - before.x(), after.y() - before.y());
    }

    /** Angle between the directions, in [0, π]; not a number where a piece stands still. */
    public double turnRadians() {
        if (before.speed() == 0 || after.speed() == 0) return Double.NaN;
        double cross = before.dx() * after.dy() - before.dy() * after.dx();
        double dot = before.dx() * after.dx() + before.dy() * after.dy();
        return Math.abs(Math.atan2(cross, dot));
    }

    private static double bend(CurvePlace place) {
        return Math.hypot(place.ddx(), place.ddy());
    }
}
