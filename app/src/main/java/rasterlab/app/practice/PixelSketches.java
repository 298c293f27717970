package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.practice.Board.BoardCell;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.BoardSpace;
import rasterlab.app.practice.Board.FigureLook;
import rasterlab.app.practice.Board.NoPick;
import rasterlab.app.practice.Board.PixelPick;
import rasterlab.app.practice.Sketch.Walked;

/** Figures that are drawn pixel by pixel: the next one is clicked. */
final class PixelSketches {
    /** Chords that an arc is drawn with. */
    private static final int CHORDS = 64;

    private PixelSketches() {}

    static Board line(Walked walked) {
        List<Point2D> ends =
                List.of(
                        QuestionPoints.of(walked.input().path("from")),
                        QuestionPoints.of(walked.input().path("to")));
        return board(walked, "x", "y", new BoardPath(ends, false, FigureLook.GIVEN));
    }

    /** The octant from (0, r), in u and v from the center. */
    static Board circle(Walked walked) {
        double radius = walked.input().path("radius").doubleValue();
        return board(walked, "u", "v", arc(radius, radius, Math.PI / 4));
    }

    /** The quarter from (0, ry), in u and v from the center. */
    static Board ellipse(Walked walked) {
        double rx = walked.input().path("rx").doubleValue();
        double ry = walked.input().path("ry").doubleValue();
        return board(walked, "u", "v", arc(rx, ry, Math.PI / 2));
    }

    /** Triangles in a depth buffer, and the pixel whose depth is asked for. */
    static Board depths(Walked walked) {
        var figures = new ArrayList<BoardFigure>();
        JsonNode size = walked.input().path("size");
        figures.add(RowSketches.border(size.path(0).intValue(), size.path(1).intValue()));
        for (int i = 0; i < walked.steps().size(); i++)
            figures.add(cell(walked.steps().get(i), "x", "y", walked.look(i)));
        if (walked.given().path("x").isNumber())
            figures.add(cell(walked.given(), "x", "y", FigureLook.ASKED));
        int number = 1;
        for (JsonNode triangle : walked.input().path("triangles")) {
            List<Point2D> corners = QuestionPoints.all(triangle);
            figures.add(new BoardPath(corners, true, FigureLook.GIVEN));
            figures.add(new BoardDot(corners.get(2), String.valueOf(number++), FigureLook.GIVEN));
        }
        return new Board(BoardSpace.PIXELS, figures, new NoPick());
    }

    /** An arc that begins on the axis of v and turns by the angle. */
    private static BoardPath arc(double rx, double ry, double angle) {
        var points = new ArrayList<Point2D>();
        for (int i = 0; i <= CHORDS; i++) {
            double at = angle * i / CHORDS;
            points.add(new Point2D.Double(rx * Math.sin(at), ry * Math.cos(at)));
        }
        return new BoardPath(points, false, FigureLook.GIVEN);
    }

    private static Board board(Walked walked, String x, String y, BoardPath exact) {
        var figures = new ArrayList<BoardFigure>();
        for (int i = 0; i < walked.steps().size(); i++)
            figures.add(cell(walked.steps().get(i), x, y, walked.look(i)));
        walked.wrong().ifPresent(answer -> figures.add(cell(answer, x, y, FigureLook.WRONG)));
        figures.add(exact);
        return new Board(BoardSpace.PIXELS, figures, new PixelPick(x, y));
    }

    private static BoardCell cell(JsonNode step, String x, String y, FigureLook look) {
        return new BoardCell(step.path(x).intValue(), step.path(y).intValue(), look);
    }
}
