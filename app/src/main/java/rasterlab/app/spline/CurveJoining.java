package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;

/** The condition that the joints of Bézier pieces keep while their points are moved. */
public enum CurveJoining {
    /** The pieces touch. */
    C0,
    /** The direction goes on: handle, joint and handle lie on one line. */
    G1,
    /** The derivative goes on: the joint is midway between its handles. */
    C1;

    /** The points once point {@code index} is at {@code to}; a joint takes its handles along. */
    List<Place> moved(List<Place> points, int index, Place to) {
        var next = new ArrayList<>(points);
        next.set(index, to);
        if (index % 3 == 0) {
            double dx = to.x() - points.get(index).x();
            double dy = to.y() - points.get(index).y();
            for (int each : new int[] {index - 1, index + 1})
                if (each >= 0 && each < points.size())
                    next.set(each, points.get(each).plus(dx, dy));
            return next;
        }
        int joint = index % 3 == 1 ? index - 1 : index + 1;
        turn(next, joint, index, 2 * joint - index);
        return next;
    }

    /** The points with every joint so; the handles before the joints stay. */
    List<Place> everywhere(List<Place> points) {
        var next = new ArrayList<>(points);
        for (int joint = 3; joint + 1 < points.size(); joint += 3)
            turn(next, joint, joint - 1, joint + 1);
        return next;
    }

    /** Brings the handle {@code other} of a joint behind the handle {@code held}. */
    private void turn(List<Place> points, int joint, int held, int other) {
        if (this == C0 || other < 0 || other >= points.size()) return;
        Place middle = points.get(joint);
        double length = middle.distance(points.get(held));
        if (length == 0) return;
        double factor = this == C1 ? 1 : middle.distance(points.get(other)) / length;
        points.set(other, middle.towards(points.get(held), -factor));
    }
}
