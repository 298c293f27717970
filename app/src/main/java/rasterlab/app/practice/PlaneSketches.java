package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.LongNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.BoardSpace;
import rasterlab.app.practice.Board.FigureLook;
import rasterlab.app.practice.Board.NamedPick;
import rasterlab.app.practice.Board.NoPick;
import rasterlab.app.practice.Board.PointPick;
import rasterlab.app.practice.Board.Target;
import rasterlab.app.practice.Sketch.Walked;

/** Polygons, points and curves in a plane. */
final class PlaneSketches {
    private static final String POLYGON = "polygon";

    private PlaneSketches() {}

    /** Ears that are cut off, and the corners, of which one is clicked. */
    static Board triangulate(Walked walked) {
        List<Point2D> corners = QuestionPoints.all(walked.input().path(POLYGON));
        var figures = new ArrayList<BoardFigure>();
        figures.add(new BoardPath(corners, true, FigureLook.GIVEN));
        addDiagonals(figures, corners, walked);
        var targets = new ArrayList<Target>();
        for (int i = 0; i < corners.size(); i++) {
            figures.add(new BoardDot(corners.get(i), String.valueOf(i), look(walked, "cut", i)));
            targets.add(new Target(LongNode.valueOf(i), List.of(corners.get(i))));
        }
        return new Board(BoardSpace.PLANE, figures, new NamedPick("cut", targets));
    }

    /** Adds the side that each ear leaves; of the last triangle all sides are there already. */
    private static void addDiagonals(
            List<BoardFigure> figures, List<Point2D> corners, Walked walked) {
        var left = new ArrayList<Integer>();
        for (int i = 0; i < corners.size(); i++) left.add(i);
        for (int i = 0; i < walked.steps().size(); i++) {
            int at = left.indexOf(walked.steps().get(i).path("cut").asInt(-1));
            if (at < 0 || left.size() <= 3) continue;
            Point2D before = corners.get(left.get((at + left.size() - 1) % left.size()));
            Point2D behind = corners.get(left.get((at + 1) % left.size()));
            figures.add(new BoardPath(List.of(before, behind), false, walked.look(i)));
            left.remove(at);
        }
    }

    /** How a thing of that number looks, by the steps whose field has it. */
    static FigureLook look(Walked walked, String field, int number) {
        for (int i = 0; i < walked.steps().size(); i++)
            if (walked.steps().get(i).path(field).asInt(-1) == number) return walked.look(i);
        boolean wrong =
                walked.wrong().filter(one -> one.path(field).asInt(-1) == number).isPresent();
        return wrong ? FigureLook.WRONG : FigureLook.GIVEN;
    }

    /** A ray from the point to the right, and the edge that it is compared with. */
    static Board inPolygon(Walked walked) {
        List<Point2D> corners = QuestionPoints.all(walked.input().path(POLYGON));
        Point2D from = QuestionPoints.of(walked.input().path("points").path(0));
        double right = corners.stream().mapToDouble(Point2D::getX).max().orElse(0) + 1;
        var figures = new ArrayList<BoardFigure>();
        figures.add(new BoardPath(corners, true, FigureLook.GIVEN));
        for (int i = 0; i < corners.size(); i++)
            figures.add(new BoardDot(corners.get(i), String.valueOf(i), FigureLook.GIVEN));
        addSide(figures, corners, walked.given().path("edge"));
        var end = new Point2D.Double(Math.max(right, from.getX() + 1), from.getY());
        figures.add(new BoardPath(List.of(from, end), false, FigureLook.DONE));
        figures.add(new BoardDot(from, "", FigureLook.NEWEST));
        return new Board(BoardSpace.PLANE, figures, new NoPick());
    }

    private static void addSide(List<BoardFigure> figures, List<Point2D> corners, JsonNode side) {
        if (!side.isNumber()) return;
        int from = side.intValue();
        figures.add(
                new BoardPath(
                        List.of(corners.get(from), corners.get((from + 1) % corners.size())),
                        false,
                        FigureLook.ASKED));
    }

    /**
     * A point beside the sides of a triangle, which are walked against the order of its corners.
     */
    static Board inTriangle(Walked walked) {
        List<Point2D> corners = QuestionPoints.all(walked.input().path("triangle"));
        Point2D point = QuestionPoints.of(walked.input().path("points").path(0));
        List<Point2D> walkedCorners = List.of(corners.get(0), corners.get(2), corners.get(1));
        var figures = new ArrayList<BoardFigure>();
        figures.add(new BoardPath(corners, true, FigureLook.GIVEN));
        addSide(figures, walkedCorners, walked.given().path("side"));
        for (int i = 0; i < corners.size(); i++)
            figures.add(new BoardDot(corners.get(i), "abc".substring(i, i + 1), FigureLook.GIVEN));
        figures.add(new BoardDot(point, "", FigureLook.NEWEST));
        return new Board(BoardSpace.PLANE, figures, new NoPick());
    }

    /** The control points, the points that came out, and the scheme of the newest one. */
    static Board curve(Walked walked) {
        List<Point2D> control = QuestionPoints.all(walked.input().path("points"));
        var figures = new ArrayList<BoardFigure>();
        figures.add(new BoardPath(control, false, FigureLook.GIVEN));
        for (int i = 0; i < control.size(); i++)
            figures.add(new BoardDot(control.get(i), String.valueOf(i), FigureLook.GIVEN));
        int newest = walked.steps().size() - 1;
        if (newest >= 0) addScheme(figures, control, walked.steps().get(newest).path("t"));
        for (int i = 0; i <= newest; i++) figures.add(point(walked.steps().get(i), walked.look(i)));
        walked.wrong().ifPresent(answer -> figures.add(point(answer, FigureLook.WRONG)));
        return new Board(BoardSpace.PLANE, figures, new PointPick("x", "y"));
    }

    private static BoardDot point(JsonNode step, FigureLook look) {
        return new BoardDot(
                new Point2D.Double(step.path("x").doubleValue(), step.path("y").doubleValue()),
                "",
                look);
    }

    private static void addScheme(List<BoardFigure> figures, List<Point2D> control, JsonNode at) {
        List<Point2D> row = control;
        while (row.size() > 2) {
            List<Point2D> next = new ArrayList<>();
            for (int i = 1; i < row.size(); i++)
                next.add(QuestionPoints.between(row.get(i - 1), row.get(i), at.doubleValue()));
            figures.add(new BoardPath(next, false, FigureLook.DONE));
            row = next;
        }
    }
}
