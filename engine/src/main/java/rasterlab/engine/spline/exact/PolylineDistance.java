package rasterlab.engine.spline.exact;

/**
 * The largest distance of one polyline's points from another polyline.
 *
 * <p>Both run from start to end of one curve, so the nearest segment is looked for a little ahead
 * of the last one first; only where that is farther than allowed, and than the worst so far, all
 * segments are tried but those in runs whose box is farther than what is found.
 */
final class PolylineDistance {
    private static final int AHEAD = 4;

    /** Segments of one run. */
    private static final int RUN = 32;

    private final Polyline to;
    private final int last;
    private final double allowed;

    /** The xmin, ymin, xmax and ymax of each run. */
    private final double[][] boxes;

    private int near;
    private double worst;

    /**
     * @param allowed up to this distance, in pixels, the segments close by are enough
     */
    PolylineDistance(Polyline to, double allowed) {
        this.to = to;
        this.allowed = allowed;
        last = Math.max(0, to.size() - 2);
        boxes = new double[last / RUN + 1][];
        for (int run = 0; run < boxes.length; run++) boxes[run] = boxOf(run * RUN);
    }

    private double[] boxOf(int first) {
        double[] box = {to.x(first), to.y(first), to.x(first), to.y(first)};
        int end = Math.min(first + RUN, to.size() - 1);
        for (int i = first + 1; i <= end; i++) {
            box[0] = Math.min(box[0], to.x(i));
            box[1] = Math.min(box[1], to.y(i));
            box[2] = Math.max(box[2], to.x(i));
            box[3] = Math.max(box[3], to.y(i));
        }
        return box;
    }

    /** Takes one more point and returns the largest distance so far. */
    double add(double x, double y) {
        double nearest = Double.POSITIVE_INFINITY;
        int from = Math.max(0, near - 1);
        for (int i = from; i <= Math.min(last, near + AHEAD); i++) {
            double distance = fromSegment(x, y, i);
            if (distance < nearest) {
                nearest = distance;
                near = i;
            }
        }
        if (nearest > Math.max(allowed, worst)) nearest = nearestOfAll(x, y, nearest);
        worst = Math.max(worst, nearest);
        return worst;
    }

    /**
     * The least distance, or any that is no larger than the worst one so far.
     *
     * @param found the distance from some segment
     */
    private double nearestOfAll(double x, double y, double found) {
        double nearest = found;
        for (int run = 0; run < boxes.length && nearest > worst; run++) {
            if (fromBox(x, y, boxes[run]) > nearest) continue;
            int end = Math.min(last, (run + 1) * RUN - 1);
            for (int i = run * RUN; i <= end; i++) {
                double distance = fromSegment(x, y, i);
                if (distance < nearest) {
                    nearest = distance;
                    near = i;
                }
            }
        }
        return nearest;
    }

    private static double fromBox(double x, double y, double[] box) {
        double dx = Math.max(0, Math.max(box[0] - x, x - box[2]));
        double dy = Math.max(0, Math.max(box[1] - y, y - box[3]));
        return Math.hypot(dx, dy);
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
