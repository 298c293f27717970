package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.TextNode;
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
import rasterlab.app.practice.Board.Target;
import rasterlab.app.practice.Sketch.Walked;

/** Segments and polygons that a window clips side by side. */
final class ClipSketches {
    private static final String WINDOW = "window";
    private static final String POLYGON = "polygon";

    /** The words of the sides, in the order in which the corners of a box begin them. */
    private static final List<String> SIDES = List.of("bottom", "right", "top", "left");

    private ClipSketches() {}

    /** The board with the rest of the segment; a side of the window can be clicked. */
    static Board segment(Walked walked) {
        List<Point2D> box = QuestionPoints.box(walked.input().path(WINDOW));
        List<Point2D> whole = QuestionPoints.flat(walked.input().path("segments").path(0));
        List<Point2D> left =
                walked.steps().isEmpty()
                        ? whole
                        : QuestionPoints.flat(
                                walked.steps().get(walked.steps().size() - 1).path("segment"));
        var figures = new ArrayList<BoardFigure>();
        figures.add(new BoardPath(box, true, FigureLook.GIVEN));
        figures.add(new BoardPath(whole, false, FigureLook.DONE));
        figures.add(new BoardPath(left, false, FigureLook.NEWEST));
        for (int i = 0; i < left.size(); i++)
            figures.add(new BoardDot(left.get(i), String.valueOf(i + 1), FigureLook.NEWEST));
        var targets = new ArrayList<Target>();
        for (int i = 0; i < SIDES.size(); i++)
            targets.add(new Target(TextNode.valueOf(SIDES.get(i)), side(box, i)));
        return new Board(BoardSpace.PLANE, figures, new NamedPick("at", targets));
    }

    private static List<Point2D> side(List<Point2D> box, int from) {
        return QuestionPoints.along(
                List.of(box.get(from), box.get((from + 1) % box.size())), false);
    }

    /** The board with the rest of the polygon, and the side whose turn it is. */
    static Board polygon(Walked walked) {
        List<Point2D> box = QuestionPoints.box(walked.input().path(WINDOW));
        JsonNode whole = walked.input().path(POLYGON);
        JsonNode left =
                walked.steps().isEmpty()
                        ? whole
                        : walked.steps().get(walked.steps().size() - 1).path(POLYGON);
        var figures = new ArrayList<BoardFigure>();
        figures.add(new BoardPath(box, true, FigureLook.GIVEN));
        String at = walked.given().path("at").asText();
        if (at.startsWith("side ")) {
            int side = Integer.parseInt(at.substring("side ".length()));
            figures.add(
                    new BoardPath(
                            List.of(box.get(side), box.get((side + 1) % box.size())),
                            false,
                            FigureLook.ASKED));
        }
        figures.add(new BoardPath(QuestionPoints.all(whole), true, FigureLook.DONE));
        figures.add(new BoardPath(QuestionPoints.all(left), true, FigureLook.NEWEST));
        for (Point2D corner : QuestionPoints.all(left))
            figures.add(new BoardDot(corner, "", FigureLook.NEWEST));
        return new Board(BoardSpace.PLANE, figures, new NoPick());
    }
}
