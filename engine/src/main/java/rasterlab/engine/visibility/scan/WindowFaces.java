package rasterlab.engine.visibility.scan;

import java.util.Arrays;
import rasterlab.engine.visibility.RowSpan;
import rasterlab.engine.visibility.Tally;

/** Which faces are to be seen in a window of pixels, as {@link Warnock} asks. */
final class WindowFaces {
    /** How far beyond an edge a window is for certain, in pixels. */
    private static final double SLACK = 1e-6;

    private final ScreenFaces faces;
    private final Tally tally;
    private final RowSpan span = new RowSpan();
    private int left;
    private int top;
    private int right;
    private int bottom;

    WindowFaces(ScreenFaces faces, Tally tally) {
        this.faces = faces;
        this.tally = tally;
    }

    /** The candidates that neither miss the window nor are hidden in all of it. */
    int[] left(int x, int y, int width, int height, int[] candidates) {
        left = x;
        top = y;
        right = x + width - 1;
        bottom = y + height - 1;
        tally.comparisons += candidates.length;
        var kept = new int[candidates.length];
        int count = 0;
        int hider = -1;
        for (int place : candidates) {
            if (disjoint(place)) continue;
            kept[count++] = place;
            if (!faces.opaque(place) || !surrounding(place)) continue;
            if (hider < 0 || nearerInMiddle(place, hider)) hider = place;
        }
        return Arrays.copyOf(kept, hider < 0 ? count : unhidden(kept, count, hider));
    }

    private int unhidden(int[] kept, int count, int hider) {
        int left = 0;
        for (int i = 0; i < count; i++)
            if (kept[i] == hider || !hides(hider, kept[i])) kept[left++] = kept[i];
        return left;
    }

    private boolean nearerInMiddle(int one, int other) {
        tally.depthTests += 2;
        return faces.nearer(one, other, left + right >> 1, top + bottom >> 1);
    }

    private boolean hides(int one, int other) {
        tally.depthTests += 2;
        return faces.nearer(one, other, left, top)
                && faces.nearer(one, other, right, top)
                && faces.nearer(one, other, left, bottom)
                && faces.nearer(one, other, right, bottom);
    }

    private boolean surrounding(int place) {
        if (!boxSurrounds(place)) return false;
        return ownsAll(place, top) && (top == bottom || ownsAll(place, bottom));
    }

    private boolean boxSurrounds(int place) {
        return faces.left(place) <= left
                && faces.right(place) > right
                && faces.top(place) <= top
                && faces.bottom(place) > bottom;
    }

    private boolean ownsAll(int place, int row) {
        faces.load(place, row, span);
        return span.from(left) == left && span.to(right + 1) == right + 1;
    }

    /** Whether it owns no pixel of the window, by its box or because one edge parts them. */
    private boolean disjoint(int place) {
        if (faces.left(place) > right
                || faces.right(place) <= left
                || faces.top(place) > bottom
                || faces.bottom(place) <= top) return true;
        if (top == bottom) {
            faces.load(place, top, span);
            return span.from(left) >= span.to(right + 1);
        }
        int first = faces.firstCorner(place);
        int end = faces.firstCorner(place + 1);
        double turn = turn(first, end);
        for (int k = first, p = end - 1; k < end; p = k++) if (parts(p, k, turn)) return true;
        return false;
    }

    /** The turn, positive where the corners run clockwise on the picture, whose y grows down. */
    private double turn(int first, int end) {
        double sum = 0;
        for (int k = first, p = end - 1; k < end; p = k++)
            sum += faces.x(p) * faces.y(k) - faces.x(k) * faces.y(p);
        return sum;
    }

    /**
     * Whether all four corner pixels lie beyond the edge from corner p to k, by a little or more.
     */
    private boolean parts(int p, int k, double turn) {
        double dx = faces.x(k) - faces.x(p);
        double dy = faces.y(k) - faces.y(p);
        double sign = turn < 0 ? -1 : 1;
        double nearX = sign * dy > 0 ? left : right;
        double nearY = sign * dx > 0 ? bottom : top;
        double inside = sign * (dx * (nearY - faces.y(p)) - dy * (nearX - faces.x(p)));
        return inside < -SLACK * (Math.abs(dx) + Math.abs(dy));
    }
}
