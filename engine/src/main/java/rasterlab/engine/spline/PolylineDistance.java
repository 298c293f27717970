package rasterlab.engine.spline;

/**
 * The largest distance of one polyline's points from another polyline.
 *
 * <p>Both run from start to end of one curve, so the nearest segment is looked for a little ahead
 * of the last one first; only where that is farther than allowed, and than the worst so far, all
 * segments are tried.
 */
final class PolylineDistance {
    private static final int AHEAD = 4;

    private final Polyline to;
    private final double allowed;
    private int near;
    private double worst;

    /**
     * @param allowed up to this distance, in pixels, the segments close by are enough
     */
    PolylineDistance(Polyline to, double allowed) {
        this.to = to;
        this.allowed = allowed;
    }

    /** Takes one more point and returns the largest distance so far. */
    double add(double x, double y) {
        int last = Math.max(0, to.size() - 2);
        double nearest = Double.POSITIVE_INFINITY;
        int from = Math.max(0, near - 1);
        for (int i = from; i <= Math.min(last, near + AHEAD); i++) {
            double distance = fromSegment(x, y, i);
            if (distance < nearest) {
                nearest = distance;
                near = i;
            }
        }
        if (nearest > Math.max(allowed, worst)) nearest = nearestOfAll(x, y, last);
        worst = Math.max(worst, nearest);
        return worst;
    }

    /** The least distance, or any that is no larger than the worst one so far. */
    private double nearestOfAll(double x, double y, int last) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i <= last && nearest > worst; i++) {
            double distance = fromSegment(x, y, i);
            if (distance < nearest) {
                nearest = distance;
                near = i;
            }
        }
        return nearest;
    }

    private double fromSegment(double x, double y, int i) {
        int next = Math.min(i + 1, to.size() - 1);
        double alongX = to.x(next) - to.x(i);
        double alongY = to.y(next) - to.y(i);
        double toX = x - to.x(i);
        double toY = y - to.y(i);
        double square = alongX * alongX + alongY * alongY;
        double share = square == 0 ? 0 : (toX * alongX + toY * alongY) / square;
        double inside = Math.max(0, Math.min(1, share));
        double dx = toX - inside * alongX;
        double dy = toY - inside * alongY;
        return Math.sqrt(dx * dx + dy * dy);
    }
}
