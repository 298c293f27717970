package rasterlab.engine.spline.exact;

/** Whether the corners of a polyline come in the order in which a curve passes them. */
final class PolylineOrder {
    private PolylineOrder() {}

    /**
     * The first corner that no way along the curve, forward from the place of the one before it,
     * passes; the first has to be near the curve's start and the last near its end. −1 where all
     * are in order.
     *
     * @param curve many points of the curve
     * @param near how far a corner may be from the place that it stands for
     */
    static int firstOutOfOrder(Polyline curve, Polyline corners, double near) {
        int last = corners.size() - 1;
        if (!(distance(curve, 0, corners, 0) <= near)) return 0;
        int chord = 0;
        for (int i = 1; i <= last; i++) {
            while (chord < curve.size() - 1 && !(toChord(curve, chord, corners, i) <= near))
                chord++;
            if (chord == curve.size() - 1) return i;
        }
        return distance(curve, curve.size() - 1, corners, last) <= near ? -1 : last;
    }

    private static double distance(Polyline curve, int point, Polyline corners, int corner) {
        return Math.hypot(corners.x(corner) - curve.x(point), corners.y(corner) - curve.y(point));
    }

    private static double toChord(Polyline curve, int chord, Polyline corners, int corner) {
        double dx = curve.x(chord + 1) - curve.x(chord);
        double dy = curve.y(chord + 1) - curve.y(chord);
        double x = corners.x(corner) - curve.x(chord);
        double y = corners.y(corner) - curve.y(chord);
        double square = dx * dx + dy * dy;
        double share = square == 0 ? 0 : (x * dx + y * dy) / square;
        double within = Math.max(0, Math.min(1, share));
        return Math.hypot(x - within * dx, y - within * dy);
    }
}
