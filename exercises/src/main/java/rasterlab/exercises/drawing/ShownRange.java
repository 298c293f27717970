package rasterlab.exercises.drawing;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.range.Bounds;

/**
 * The rows or columns of a table that a picture has a place for.
 *
 * @param first the first one shown, from 0
 * @param count how many are shown
 * @param all how many there are
 */
record ShownRange(int first, int count, int all) {
    /** The place in {@link #lines} of what is left out. */
    static final int GAP = -1;

    ShownRange {
        Bounds.requireAtLeast("first", first, 0);
    }

    /** The range of at most so many, with one of them as near to the middle as the ends allow. */
    static ShownRange around(int center, int most, int all) {
        int count = Math.min(most, all);
        int first = Math.max(0, Math.min(center - count / 2, all - count));
        return new ShownRange(first, count, all);
    }

    /** Whether nothing is left out. */
    boolean isWhole() {
        return count == all;
    }

    int last() {
        return first + count - 1;
    }

    /** The indices shown, in order, with {@link #GAP} where some before or behind are not. */
    List<Integer> lines() {
        var lines = new ArrayList<Integer>();
        if (first > 0) lines.add(GAP);
        for (int i = first; i <= last(); i++) lines.add(i);
        if (last() < all - 1) lines.add(GAP);
        return lines;
    }
}
