package rasterlab.engine.polygon.triangulation;

/**
 * The rest of a simple polygon while ears are cut off it.
 *
 * <p>Corner i is an ear where the turn from its predecessor to its successor is to the left and no
 * other corner lies in the triangle of the three or on its border. Such a triangle can be cut off,
 * and what is left is simple again; each simple polygon has an ear, corners on straight sides
 * included. Of the corners in such a triangle one is always not convex, so only those are tried.
 * They become convex or go, never the other way round.
 *
 * <p>Where edges are gone along both ways, as {@link Bridges} allows, several corners stand in one
 * place. Those in the places of the three are in no one's way, unless an edge from the place of
 * corner i runs into the triangle. A corner from which the way goes back where it came from is
 * taken out without a triangle, and so is one of its two neighbours.
 *
 * <p>All tests are exact. Source: G. H. Meisters, Polygons have ears, American Mathematical Monthly
 * 82, 1975, pp. 648–651.
 */
final class EarRing {
    private final Corners corners;
    private final int[] next;
    private final int[] previous;
    private final boolean[] gone;
    private final Places places;
    private final int[] notConvex;
    private int notConvexCount;
    private int size;
    private long turns;

    /**
     * @param corners counter-clockwise, of a simple polygon
     */
    EarRing(Corners corners) {
        this.corners = corners;
        size = corners.size();
        next = new int[size];
        previous = new int[size];
        notConvex = new int[size];
        gone = new boolean[size];
        for (int i = 0; i < size; i++) {
            next[i] = corners.after(i);
            previous[i] = corners.before(i);
        }
        places = Places.of(corners);
        if (places.shared()) for (int i = 0; i < corners.size(); i++) takeSpikesAt(i);
        for (int i = 0; i < corners.size(); i++)
            if (contains(i) && !convex(i)) notConvex[notConvexCount++] = i;
    }

    int size() {
        return size;
    }

    int next(int i) {
        return next[i];
    }

    int previous(int i) {
        return previous[i];
    }

    /** Whether corner i is still there. */
    boolean contains(int i) {
        return !gone[i];
    }

    /** Number of corner i in the input. */
    int number(int i) {
        return corners.number[i];
    }

    /** Exact turns computed so far. */
    long turns() {
        return turns;
    }

    /** Squared length of the diagonal that cuts corner i off. */
    double diagonal(int i) {
        double dx = corners.x[next[i]] - corners.x[previous[i]];
        double dy = corners.y[next[i]] - corners.y[previous[i]];
        return dx * dx + dy * dy;
    }

    boolean isEar(int i) {
        int a = previous[i];
        int c = next[i];
        if (!convex(i)) return false;
        if (size == 3) return true;
        double left = Math.min(corners.x[a], Math.min(corners.x[i], corners.x[c]));
        double right = Math.max(corners.x[a], Math.max(corners.x[i], corners.x[c]));
        double low = Math.min(corners.y[a], Math.min(corners.y[i], corners.y[c]));
        double high = Math.max(corners.y[a], Math.max(corners.y[i], corners.y[c]));
        for (int k = 0; k < notConvexCount; k++) {
            int p = notConvex[k];
            double x = corners.x[p];
            double y = corners.y[p];
            if (x < left || x > right || y < low || y > high) continue;
            if (p != a && p != i && p != c && covers(a, i, c, p)) return false;
        }
        return !places.shared() || !isEntered(a, i, c);
    }

    /** Whether an edge at another corner in the place of b runs into the triangle. */
    private boolean isEntered(int a, int b, int c) {
        for (int p : places.corners(b))
            if (p != b && contains(p))
                for (int q : new int[] {previous[p], next[p]})
                    if (turn(b, c, q) > 0 && turn(b, a, q) < 0) return true;
        return false;
    }

    private boolean covers(int a, int b, int c, int p) {
        if (places.same(p, a) || places.same(p, b) || places.same(p, c)) return false;
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }

    /** Makes the refusal of a way without an ear; only ways with bridges come to that. */
    static IllegalArgumentException crosswise() {
        return new IllegalArgumentException(
                "where edges are gone along both ways, the ways cross in a corner");
    }

    /**
     * Takes corner i out; its neighbours may now be convex.
     *
     * @return those that have another neighbour now, of which some may be gone
     */
    int[] cut(int i) {
        int before = previous[i];
        int after = next[i];
        takeOut(i);
        int[] changed = {before, after};
        if (places.shared())
            changed = new int[] {before, after, takeSpikesAt(before), takeSpikesAt(after)};
        int kept = 0;
        for (int k = 0; k < notConvexCount; k++) {
            int p = notConvex[k];
            if (!contains(p)) continue;
            boolean asked = places.shared() || p == before || p == after;
            if (!asked || !convex(p)) notConvex[kept++] = p;
        }
        notConvexCount = kept;
        return changed;
    }

    private void takeOut(int i) {
        next[previous[i]] = next[i];
        previous[next[i]] = previous[i];
        gone[i] = true;
        size--;
    }

    /**
     * Takes corner i out if the way goes back there, with the corner it goes back to, and again
     * where it then goes back.
     *
     * @return the last corner where it was asked
     */
    private int takeSpikesAt(int i) {
        int at = i;
        while (size > 2 && contains(at) && places.same(previous[at], next[at])) {
            int before = previous[at];
            takeOut(next[at]);
            takeOut(at);
            at = before;
        }
        return at;
    }

    private boolean convex(int i) {
        return turn(previous[i], i, next[i]) > 0;
    }

    private int turn(int i, int j, int k) {
        turns++;
        return corners.turn(i, j, k);
    }
}
