package rasterlab.engine.visibility.exact;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import rasterlab.engine.scene.Mesh;

/**
 * The pixels that a face owns, row by row.
 *
 * <p>A line of sight meets a face where an odd number of the face's edges cross its row on its
 * right, both seen from the eye: the plane through the eye and a row of pixels parts the corners
 * into those above or on it and those below, an edge between the two crosses it, and on which side
 * of the edge the line of sight passes is the sign of a linear function of the column. That needs
 * no corner before the eye, so that nothing is clipped; what of the face's plane is not drawn is
 * cut off along the row. Two faces with a common edge ask the same question of it and so own each
 * pixel once.
 */
final class SeenFace {
    private final int face;
    private final int width;
    private final PixelSign[] levels;
    private final PixelSign[] edges;
    private final List<PixelSign> limits;
    private final int top;
    private final int bottom;

    /**
     * @param limits what must be at least 0 where the face's plane is drawn
     */
    SeenFace(Sightings sightings, int face, List<PixelSign> limits) {
        this.face = face;
        this.limits = limits;
        width = sightings.view().fit().width();
        int height = sightings.view().fit().height();
        Mesh mesh = sightings.view().mesh();
        int corners = mesh.cornerCount(face);
        levels = new PixelSign[corners];
        edges = new PixelSign[corners];
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < corners; k++) {
            int last = mesh.corner(face, k == 0 ? corners - 1 : k - 1);
            int corner = mesh.corner(face, k);
            levels[k] = sightings.level(corner);
            edges[k] = sightings.edge(last, corner);
            Bounded row = sightings.row(corner);
            least = Math.min(least, row.value() - row.error());
            most = Math.max(most, row.value() + row.error());
        }
        // A row more on each side is more than what rounding takes here; NaN leaves all rows.
        top = least > 1 ? (int) Math.min(height, least - 1) : 0;
        bottom = most < height - 2 ? (int) Math.max(0, most + 2) : height;
    }

    int face() {
        return face;
    }

    /** The first row that may hold a pixel of the face. */
    int top() {
        return top;
    }

    /** The row after the last that may. */
    int bottom() {
        return bottom;
    }

    /** Receives columns. */
    interface Columns {
        /** Takes the columns [from, to). */
        void take(int from, int to);
    }

    /** Sends the owned pixels of a row from left to right. */
    void row(int y, Columns out) {
        var flips = new int[edges.length];
        int count = 0;
        boolean inside = false;
        boolean wasAbove = above(edges.length - 1, y);
        for (int k = 0; k < edges.length; k++) {
            boolean isAbove = above(k, y);
            if (isAbove != wasAbove) {
                PixelSign edge = edges[k];
                int onRight = isAbove ? 1 : -1;
                boolean first = edge.at(0, y) == onRight;
                inside ^= first;
                if (first != (edge.at(width - 1, y) == onRight))
                    flips[count++] =
                            change(
                                    x -> (edge.at(x, y) == onRight) != first,
                                    edge.column(y),
                                    0,
                                    width - 1);
            }
            wasAbove = isAbove;
        }
        Arrays.sort(flips, 0, count);
        int from = 0;
        for (int i = 0; i <= count; i++) {
            int to = i < count ? flips[i] : width;
            if (inside && from < to) limited(y, from, to, out);
            inside = !inside;
            from = to;
        }
    }

    private boolean above(int corner, int y) {
        return levels[corner].at(0, y) >= 0;
    }

    private void limited(int y, int from, int to, Columns out) {
        int first = from;
        int end = to;
        for (PixelSign limit : limits) {
            boolean atFirst = limit.at(first, y) >= 0;
            boolean atLast = limit.at(end - 1, y) >= 0;
            if (atFirst && atLast) continue;
            if (!atFirst && !atLast) return;
            int change =
                    change(x -> limit.at(x, y) >= 0 != atFirst, limit.column(y), first, end - 1);
            if (atFirst) end = change;
            else first = change;
        }
        out.take(first, end);
    }

    /**
     * The first column at which something holds that does not at {@code from} and does at {@code
     * to}: looked for beside a guess, then by halving.
     */
    private static int change(IntPredicate holds, double guess, int from, int to) {
        int not = from;
        int does = to;
        int next = (int) Math.ceil(guess);
        for (int tries = 0; does - not > 1; tries++) {
            boolean guessed = tries < 2 && next > not && next < does;
            int at = guessed ? next : not + does >>> 1;
            if (holds.test(at)) does = at;
            else not = at;
            next = at == does ? at - 1 : at + 1;
        }
        return does;
    }
}
