package rasterlab.app.coordinates.figure;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Where labels stand beside their places: where they hide the fewest lines and other labels, to the
 * upper right if that is as good.
 */
final class MarkLabelPlaces {
    /** View units from a place to its label, the nearest first. */
    private static final int[] AWAY = {7, 14, 22};

    /**
     * The sides on which a label may stand: right, left or in the middle; above, below or beside.
     */
    private static final int[][] SIDES = {
        {1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}
    };

    private final Rectangle view;
    private final List<Line2D> lines;
    private final List<Rectangle> taken;

    /**
     * @param view what is seen
     * @param lines should not be hidden
     * @param taken where labels and rings are already
     */
    MarkLabelPlaces(Rectangle view, List<Line2D> lines, List<Rectangle> taken) {
        this.view = view;
        this.lines = List.copyOf(lines);
        this.taken = new ArrayList<>(taken);
    }

    /**
     * Takes a place.
     *
     * @param x of what the label belongs to
     * @param y of what the label belongs to
     * @param wide of the label
     * @param high of the label
     */
    Rectangle take(double x, double y, int wide, int high) {
        var best = new Rectangle();
        int least = Integer.MAX_VALUE;
        for (int away : AWAY)
            for (int[] side : SIDES) {
                var place =
                        new Rectangle(
                                (int) Math.round(start(x, side[0], away, wide)),
                                (int) Math.round(start(y, side[1], away, high)),
                                wide,
                                high);
                int hidden = hidden(place);
                if (hidden >= least) continue;
                least = hidden;
                best = place;
            }
        taken.add(best);
        return best;
    }

    private static double start(double at, int side, int away, int size) {
        return side > 0 ? at + away : side < 0 ? at - away - size : at - size / 2.0;
    }

    private int hidden(Rectangle place) {
        int hidden = view.contains(place) ? 0 : lines.size() + taken.size() + 1;
        for (Line2D line : lines) if (line.intersects(place)) hidden++;
        for (Rectangle other : taken) if (other.intersects(place)) hidden++;
        return hidden;
    }
}
