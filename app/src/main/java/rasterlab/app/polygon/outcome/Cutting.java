package rasterlab.app.polygon.outcome;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.app.polygon.figure.CornerList;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.outcome.CutAnswer.CutTriangle;
import rasterlab.app.polygon.outcome.CutAnswer.TriangleFault;
import rasterlab.contract.Triangulator;
import rasterlab.engine.polygon.ExactMembership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangulation.ExactTriangulation;
import rasterlab.engine.polygon.triangulation.SteppedTriangulator;
import rasterlab.engine.polygon.triangulation.TriangleWalk;
import rasterlab.engine.polygon.triangulation.Triangles;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.NoAnswer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/** Cuts a polygon into triangles by a method, and looks at each of them. */
final class Cutting {
    private final Points corners;
    private final ExactTriangulation exact;

    private Cutting(Points corners) {
        this.corners = corners;
        exact = new ExactTriangulation(corners);
    }

    static MethodOutcome of(
            Topic<Triangulator, Points, Triangles> topic, CutFigure figure, String method) {
        Points corners = CornerList.points(figure.corners());
        var cutting = new Cutting(corners);
        var cuts = new ArrayList<CutTriangle>();
        var attempt =
                new Attempt(
                        () -> {
                            Triangulator triangulator = topic.method(method).implementation();
                            if (triangulator instanceof SteppedTriangulator stepped)
                                cutting.drain(stepped, cuts);
                            else
                                cutting.take(
                                        topic.record(triangulator, corners, topic.mostItems()),
                                        cuts);
                        });
        Triangles right = topic.exact(corners, topic.mostItems());
        Deviation deviation =
                attempt.ending() == MethodOutcome.MethodEnding.REFUSED
                        ? Deviation.NONE
                        : topic.compare(corners, right, triangles(cuts));
        return new MethodOutcome(
                method,
                attempt.ending(),
                attempt.message(),
                deviation,
                new CutAnswer(cuts, right.size()));
    }

    private void drain(SteppedTriangulator stepped, List<CutTriangle> cuts) {
        TriangleWalk walk = stepped.walk(corners.xs(), corners.ys());
        while (walk.advance()) {
            if (cuts.size() == 2 * corners.size())
                throw new LimitReached(2 * corners.size(), triangles(cuts));
            int[] abc = {walk.a(), walk.b(), walk.c()};
            cuts.add(new CutTriangle(abc[0], abc[1], abc[2], walk.turns(), fault(abc)));
        }
    }

    /** Takes an answer triangle by triangle; how many turns they took is not known. */
    private void take(Triangles answer, List<CutTriangle> cuts) {
        for (int i = 0; i < answer.size(); i++) {
            int[] abc = {answer.corner(i, 0), answer.corner(i, 1), answer.corner(i, 2)};
            for (int corner : abc)
                if (corner < 0 || corner >= corners.size())
                    throw new NoAnswer(
                            Verdict.Kind.WRONG,
                            "your program's answer cannot be used: there is no corner " + corner);
            cuts.add(new CutTriangle(abc[0], abc[1], abc[2], 0, fault(abc)));
        }
    }

    private TriangleFault fault(int[] abc) {
        int turn = exact.doubledArea(abc[0], abc[1], abc[2]).signum();
        if (turn == 0) return TriangleFault.NO_AREA;
        if (turn < 0) return TriangleFault.CLOCKWISE;
        var inside =
                new ExactMembership(
                        Points.of(
                                corners.x(abc[0]),
                                corners.y(abc[0]),
                                corners.x(abc[1]),
                                corners.y(abc[1]),
                                corners.x(abc[2]),
                                corners.y(abc[2])));
        for (int i = 0; i < corners.size(); i++)
            if (isOther(i, abc) && inside.contains(corners.x(i), corners.y(i)))
                return TriangleFault.HOLDS_A_CORNER;
        return TriangleFault.NONE;
    }

    private boolean isOther(int corner, int[] abc) {
        for (int each : abc)
            if (corners.x(each) == corners.x(corner) && corners.y(each) == corners.y(corner))
                return false;
        return true;
    }

    private static Triangles triangles(List<CutTriangle> cuts) {
        return new Triangles(
                cuts.stream()
                        .flatMapToInt(cut -> IntStream.of(cut.a(), cut.b(), cut.c()))
                        .toArray());
    }
}
