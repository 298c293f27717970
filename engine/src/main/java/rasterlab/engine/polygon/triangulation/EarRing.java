package rasterlab.engine.polygon.triangulation;

/**
 * What is left of a simple polygon while ears are cut off it.
 *
 * <p>Corner i is an ear where the turn from its predecessor to its successor is to the left and no
 * other corner lies in the triangle of the three or on its border. Such a triangle can be cut off,
 * and what is left is simple again; each simple polygon has an ear, corners on straight sides
 * included. Of the corners in such a triangle one is always not convex, so only those are tried.
 * They become convex or go, never the other way round.
 *
 * <p>All tests are exact. Source: G. H. Meisters, Polygons have ears, American Mathematical Monthly
 * 82, 1975, pp. 648–651.
 */
final class EarRing {
    private final Corners corners;
    private final int[] next;
    private final int[] previous;
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
        for (int i = 0; i < size; i++) {
            next[i] = corners.after(i);
            previous[i] = corners.before(i);
        }
        for (int i = 0; i < size; i++) if (!convex(i)) notConvex[notConvexCount++] = i;
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
        return next[previous[i]] == i;
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
        return true;
    }

    private boolean covers(int a, int b, int c, int p) {
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }

    /** Takes corner i out; its neighbours may now be convex. */
    void cut(int i) {
        next[previous[i]] = next[i];
        previous[next[i]] = previous[i];
        size--;
        int kept = 0;
        for (int k = 0; k < notConvexCount; k++) {
            int p = notConvex[k];
            boolean changed = p == previous[i] || p == next[i];
            if (!changed || !convex(p)) notConvex[kept++] = p;
        }
        notConvexCount = kept;
    }

    private boolean convex(int i) {
        return turn(previous[i], i, next[i]) > 0;
    }

    private int turn(int i, int j, int k) {
        turns++;
        return corners.turn(i, j, k);
    }
}
