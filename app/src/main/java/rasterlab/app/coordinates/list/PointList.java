package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.DoubleStream;
import rasterlab.engine.transform.axis.AxisTurn;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.view.ViewTask;

/**
 * Points of space and the matrices they go through: an input of a topic that has both.
 *
 * @param items the matrix that the points go through first is the last one
 * @param points coordinates, one point after the other
 */
record PointList(List<ListItem> items, List<Double> points) {
    /** Name of the matrix of an eye on a sphere. */
    static final String VIEW = "VIEW_LEFT";

    /** Name of the matrix of a rotation about a line. */
    static final String TURN = "ROTAXIS";

    PointList {
        items = List.copyOf(items);
        points = List.copyOf(points);
    }

    /**
     * The chain's matrices, after one that gives plain points their common h where it is not 1.
     *
     * @throws IllegalArgumentException for a chain of the plane, or one whose points differ in h
     */
    static PointList of(Chain chain) {
        if (chain.dimension() != 3)
            throw new IllegalArgumentException(
                    "dimension must be 3 to be shown in space, got " + chain.dimension());
        var items = new ArrayList<ListItem>();
        double h = chain.h().length == 0 ? 1 : chain.h()[0];
        if (DoubleStream.of(chain.h()).anyMatch(each -> each != h))
            throw new IllegalArgumentException(
                    "h must be the same for all points to be shown, got "
                            + Arrays.toString(chain.h()));
        if (h != 1)
            items.add(ListItem.of(ListItem.FREE, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, h));
        for (double[] cells : chain.matrices()) items.add(ListItem.of(ListItem.FREE, cells));
        Collections.reverse(items);
        return new PointList(items, list(chain.points()));
    }

    static PointList of(ViewTask look) {
        ListItem view = ListItem.of(VIEW, look.theta(), look.phi(), look.rho());
        return new PointList(List.of(view), list(look.points()));
    }

    static PointList of(AxisTurn turn) {
        double[] through = turn.through();
        double[] along = turn.direction();
        ListItem axis =
                ListItem.of(
                        TURN,
                        through[0],
                        through[1],
                        through[2],
                        along[0],
                        along[1],
                        along[2],
                        turn.degrees());
        return new PointList(List.of(axis), list(turn.points()));
    }

    private static List<Double> list(double[] numbers) {
        return Arrays.stream(numbers).boxed().toList();
    }
}
