package rasterlab.app.study.chart;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.study.chart.LabelSpots.LabelSpot;

/**
 * Where labels of points stand in a chart: close to their points, or further off with a leader.
 *
 * <p>Each takes the best spot that the ones before it leave; then each in turn takes a better one
 * if there is one, for which it may send another away that has nearly as good a spot elsewhere. The
 * same labels have always the same places.
 */
final class LabelPlaces {
    /** The gap between two labels in a row, in pixels, so that they are not read as one. */
    static final int GAP = 8;

    /** The cost of two leaders that cross, as of {@link LabelSpot}. */
    private static final double CROSSED = 120;

    /** The least gain for which another label is sent away. */
    private static final double GAIN = 10;

    /** Charts are done after a few; of more, the places get hardly better. */
    private static final int ROUNDS = 8;

    private final List<List<LabelSpot>> spots;
    private final LabelSpot[] taken;

    /** A label and the point to which it belongs. */
    record PointLabel(Point point, Dimension size) {}

    /**
     * @param box of the label
     * @param leader from the point's marker to the box; empty where the label is close to it
     */
    record LabelPlace(Rectangle box, Optional<Line2D> leader) {}

    private LabelPlaces(LabelSpots around, List<PointLabel> labels) {
        spots = labels.stream().map(around::around).toList();
        taken = new LabelSpot[labels.size()];
        Arrays.fill(taken, LabelSpots.NOWHERE);
    }

    /**
     * The place of each label, in their order; empty where labels and markers leave no room at all.
     * No label stands on a marker, another label or a leader.
     *
     * @param inside where labels may stand
     * @param points at which markers are drawn
     * @param lines between points
     */
    static List<Optional<LabelPlace>> of(
            Rectangle inside, List<Point> points, List<Line2D> lines, List<PointLabel> labels) {
        var places = new LabelPlaces(new LabelSpots(inside, points, lines), labels);
        places.search();
        return Arrays.stream(places.taken).map(LabelSpot::place).toList();
    }

    private void search() {
        for (int label = 0; label < taken.length; label++) taken[label] = best(label);
        boolean better = true;
        for (int round = 0; better && round < ROUNDS; round++) {
            better = false;
            for (int label = 0; label < taken.length; label++)
                better |= moves(label) || sendsAnotherAway(label);
        }
    }

    /** The label's best spot beside the others. */
    private LabelSpot best(int label) {
        LabelSpot best = LabelSpots.NOWHERE;
        double least = best.cost();
        for (LabelSpot spot : spots.get(label)) {
            if (spot.cost() >= least) break;
            double cost = cost(label, spot);
            if (cost >= least) continue;
            least = cost;
            best = spot;
        }
        return best;
    }

    /** The cost of the label there, beside the others. */
    private double cost(int label, LabelSpot spot) {
        double cost = spot.cost();
        for (int other = 0; other < taken.length; other++)
            if (other != label) cost += conflict(spot, taken[other]);
        return cost;
    }

    private boolean moves(int label) {
        double now = cost(label, taken[label]);
        LabelSpot best = best(label);
        if (cost(label, best) >= now) return false;
        taken[label] = best;
        return true;
    }

    private boolean sendsAnotherAway(int label) {
        double now = cost(label, taken[label]);
        for (LabelSpot spot : spots.get(label)) {
            if (spot.cost() + GAIN >= now) return false;
            List<Integer> inTheWay = inTheWay(label, spot);
            if (inTheWay.size() == 1 && sendsAway(label, spot, inTheWay.get(0))) return true;
        }
        return false;
    }

    private List<Integer> inTheWay(int label, LabelSpot spot) {
        return IntStream.range(0, taken.length)
                .filter(other -> other != label)
                .filter(other -> Double.isInfinite(conflict(spot, taken[other])))
                .limit(2)
                .boxed()
                .toList();
    }

    private boolean sendsAway(int label, LabelSpot spot, int other) {
        LabelSpot labelBefore = taken[label];
        LabelSpot otherBefore = taken[other];
        double before = cost(label, labelBefore) + cost(other, otherBefore);
        taken[label] = spot;
        taken[other] = best(other);
        if (cost(label, spot) + cost(other, taken[other]) + GAIN < before) return true;
        taken[label] = labelBefore;
        taken[other] = otherBefore;
        return false;
    }

    /** The cost of two spots beside each other; infinite where only one can be taken. */
    private static double conflict(LabelSpot one, LabelSpot two) {
        if (!one.reach().intersects(two.reach())) return 0;
        LabelPlace here = one.place().get();
        LabelPlace there = two.place().get();
        if (LabelSpots.grown(here.box(), GAP, 1).intersects(there.box())
                || crosses(here, there)
                || crosses(there, here)) return Double.POSITIVE_INFINITY;
        return here.leader().isPresent()
                        && there.leader().isPresent()
                        && here.leader().get().intersectsLine(there.leader().get())
                ? CROSSED
                : 0;
    }

    /** Whether the leader of one runs through the other's box. */
    private static boolean crosses(LabelPlace one, LabelPlace other) {
        return one.leader()
                .filter(leader -> leader.intersects(LabelSpots.grown(other.box(), 2, 1)))
                .isPresent();
    }
}
