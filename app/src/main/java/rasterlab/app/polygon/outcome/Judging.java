package rasterlab.app.polygon.outcome;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.outcome.InsideAnswer.AskedSide;
import rasterlab.engine.polygon.ExactMembership;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.MembershipComparison;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.polygon.inside.EdgeWalk;
import rasterlab.engine.polygon.inside.SteppedPolygonTest;
import rasterlab.engine.polygon.triangle.SideWalk;
import rasterlab.engine.polygon.triangle.SteppedTriangleTest;
import rasterlab.engine.study.Deviation;

/** Judges a figure's points by a method, the first one step by step. */
final class Judging {
    private Judging() {}

    static MethodOutcome of(
            PolygonTopics topics, PolygonMode mode, InsideFigure figure, String method) {
        ShapeAndPoints input = figure.input();
        Points corners = input.corners();
        Points points = input.points();
        Membership exact = new Membership(points, points.size(), new ExactMembership(corners));
        var sides = new ArrayList<AskedSide>();
        var judged = new ArrayList<Membership>();
        var attempt =
                new Attempt(
                        () -> {
                            Object test = topics.method(mode, method).implementation();
                            if (test instanceof SteppedTriangleTest stepped)
                                ask(stepped, corners, points, sides);
                            else if (test instanceof SteppedPolygonTest stepped)
                                ask(stepped, corners, points, sides);
                            judged.add(
                                    new Membership(
                                            points,
                                            points.size(),
                                            topics.judge(mode, method, corners)));
                        });
        Deviation deviation =
                judged.isEmpty()
                        ? Deviation.NONE
                        : MembershipComparison.compare(input, exact, judged.get(0));
        List<Boolean> inside = judged.isEmpty() ? List.of() : listed(judged.get(0));
        return new MethodOutcome(
                method,
                attempt.ending(),
                attempt.message(),
                deviation,
                new InsideAnswer(inside, listed(exact), sides, !isStepped(topics, mode, method)));
    }

    private static boolean isStepped(PolygonTopics topics, PolygonMode mode, String method) {
        Object test = topics.method(mode, method).implementation();
        return test instanceof SteppedTriangleTest || test instanceof SteppedPolygonTest;
    }

    private static List<Boolean> listed(Membership membership) {
        var listed = new ArrayList<Boolean>();
        for (int i = 0; i < membership.size(); i++) listed.add(membership.inside(i));
        return listed;
    }

    private static void ask(
            SteppedTriangleTest test, Points corners, Points points, List<AskedSide> sides) {
        SideWalk walk =
                test.walk(
                        corners.x(0),
                        corners.y(0),
                        corners.x(1),
                        corners.y(1),
                        corners.x(2),
                        corners.y(2),
                        points.x(0),
                        points.y(0));
        while (walk.advance()) {
            int[] ends = test.corners(walk.side());
            sides.add(new AskedSide(ends[0], ends[1], walk.value()));
        }
    }

    private static void ask(
            SteppedPolygonTest test, Points corners, Points points, List<AskedSide> sides) {
        EdgeWalk walk = test.walk(corners.xs(), corners.ys(), points.x(0), points.y(0));
        while (walk.advance())
            sides.add(new AskedSide(walk.edge(), (walk.edge() + 1) % corners.size(), walk.count()));
    }
}
