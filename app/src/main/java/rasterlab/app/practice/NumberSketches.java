package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.BoardSpace;
import rasterlab.app.practice.Board.FigureLook;
import rasterlab.app.practice.Board.NoPick;
import rasterlab.app.practice.Sketch.Walked;

/** Sketches for questions whose numbers nobody can click. */
final class NumberSketches {
    /** Chords of a circle. */
    private static final int CHORDS = 90;

    private NumberSketches() {}

    /**
     * A point that is turned about the origin: x and then y of each turn, a line while only one of
     * them is known.
     */
    static Board turns(Walked walked) {
        Point2D from = QuestionPoints.of(walked.input().path("points").path(0));
        double radius = Math.max(1, from.distance(0, 0));
        var figures = new ArrayList<BoardFigure>();
        figures.add(circle(radius));
        addTurned(figures, from, "0", FigureLook.GIVEN);
        List<JsonNode> steps = walked.steps();
        for (int i = 0; i < steps.size(); i++) {
            double value = steps.get(i).path("value").doubleValue();
            String turn = steps.get(i).path("turn").asText();
            if (i % 2 == 1) {
                double x = steps.get(i - 1).path("value").doubleValue();
                addTurned(figures, new Point2D.Double(x, value), turn, walked.look(i));
            } else if (i == steps.size() - 1)
                figures.add(
                        new BoardPath(
                                List.of(
                                        new Point2D.Double(value, -radius),
                                        new Point2D.Double(value, radius)),
                                false,
                                FigureLook.NEWEST));
        }
        return new Board(BoardSpace.PLANE, figures, new NoPick());
    }

    private static BoardPath circle(double radius) {
        List<Point2D> points = new ArrayList<>();
        for (int i = 0; i < CHORDS; i++) {
            double angle = 2 * Math.PI * i / CHORDS;
            points.add(new Point2D.Double(radius * Math.cos(angle), radius * Math.sin(angle)));
        }
        return new BoardPath(points, true, FigureLook.WALL);
    }

    private static void addTurned(
            List<BoardFigure> figures, Point2D at, String label, FigureLook look) {
        figures.add(new BoardPath(List.of(new Point2D.Double(), at), false, look));
        figures.add(new BoardDot(at, label, look));
    }

    /** Knots of a function, and the one that the step is about. */
    static Board knots(Walked walked) {
        JsonNode x = walked.input().path("x");
        JsonNode y = walked.input().path("y");
        List<Point2D> knots = new ArrayList<>();
        for (int i = 0; i < x.size(); i++)
            knots.add(new Point2D.Double(x.get(i).doubleValue(), y.path(i).doubleValue()));
        var figures = new ArrayList<BoardFigure>();
        figures.add(new BoardPath(knots, false, FigureLook.DONE));
        int asked = walked.given().path("index").asInt(-1);
        for (int i = 0; i < knots.size(); i++)
            figures.add(
                    new BoardDot(
                            knots.get(i),
                            String.valueOf(i),
                            i == asked ? FigureLook.ASKED : FigureLook.GIVEN));
        return new Board(BoardSpace.DEPTH, figures, new NoPick());
    }

    /** Texels with their numbers, from below, and the point that is looked up among them. */
    static Board texels(Walked walked) {
        JsonNode picture = walked.input().path("picture");
        JsonNode at = walked.input().path("pixels").path(0);
        int rows = picture.size();
        int columns = picture.path(0).size();
        var figures = new ArrayList<BoardFigure>();
        for (int row = 0; row < rows; row++)
            for (int column = 0; column < columns; column++) {
                String level = picture.get(rows - 1 - row).get(column).asText();
                figures.add(texel(column, row, FigureLook.WALL));
                figures.add(
                        new BoardDot(
                                new Point2D.Double(column + 0.5, row + 0.5),
                                level,
                                FigureLook.GIVEN));
            }
        for (int i = 0; i < walked.steps().size(); i++)
            add(figures, walked.steps().get(i), walked.look(i));
        add(figures, walked.given(), FigureLook.ASKED);
        var place =
                new Point2D.Double(
                        at.path(0).doubleValue() * columns, at.path(1).doubleValue() * rows);
        figures.add(new BoardDot(place, "", FigureLook.NEWEST));
        return new Board(BoardSpace.PLANE, figures, new NoPick());
    }

    private static void add(List<BoardFigure> figures, JsonNode step, FigureLook look) {
        if (step.path("column").isNumber())
            figures.add(
                    texel(
                            step.path("column").intValue(),
                            step.path("row-from-below").intValue(),
                            look));
    }

    private static BoardPath texel(int column, int row, FigureLook look) {
        return new BoardPath(
                List.of(
                        new Point2D.Double(column, row),
                        new Point2D.Double(column + 1, row),
                        new Point2D.Double(column + 1, row + 1),
                        new Point2D.Double(column, row + 1)),
                true,
                look);
    }

    /** The view volume from the side and from above at once, z upward: x and y have one shape. */
    static Board volume(Walked walked) {
        double near = walked.input().path("zmin").doubleValue();
        JsonNode whole = walked.input().path("segments").path(0);
        JsonNode left = whole;
        for (JsonNode step : walked.steps())
            if (step.path("segment").size() == 6) left = step.path("segment");
        var figures = new ArrayList<BoardFigure>();
        figures.add(
                new BoardPath(
                        List.of(
                                new Point2D.Double(-near, near),
                                new Point2D.Double(near, near),
                                new Point2D.Double(1, 1),
                                new Point2D.Double(-1, 1)),
                        true,
                        FigureLook.GIVEN));
        for (int axis = 0; axis < 2; axis++) {
            String name = axis == 0 ? "x" : "y";
            figures.add(new BoardPath(side(whole, axis), false, FigureLook.DONE));
            figures.add(new BoardPath(side(left, axis), false, FigureLook.NEWEST));
            for (Point2D end : side(left, axis))
                figures.add(new BoardDot(end, name, FigureLook.NEWEST));
        }
        return new Board(BoardSpace.PLANE, figures, new NoPick());
    }

    /** A segment's x or y to the right, its z upward. */
    private static List<Point2D> side(JsonNode segment, int axis) {
        return List.of(
                new Point2D.Double(segment.path(axis).doubleValue(), segment.path(2).doubleValue()),
                new Point2D.Double(
                        segment.path(3 + axis).doubleValue(), segment.path(5).doubleValue()));
    }
}
