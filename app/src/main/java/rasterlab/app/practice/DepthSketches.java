package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.LongNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.BoardSpace;
import rasterlab.app.practice.Board.FigureLook;
import rasterlab.app.practice.Board.NamedPick;
import rasterlab.app.practice.Board.Target;
import rasterlab.app.practice.Sketch.Walked;

/** Faces seen across the direction in which the eye looks, so that their depths are seen. */
final class DepthSketches {
    private DepthSketches() {}

    /** The polygons seen from above: x to the right, depth upward from the eye. */
    static Board order(Walked walked) {
        JsonNode polygons = walked.input().path("polygons");
        var figures = new ArrayList<BoardFigure>();
        var targets = new ArrayList<Target>();
        figures.add(new BoardDot(fromAbove(walked.input().path("eye")), "eye", FigureLook.DONE));
        for (int i = 0; i < polygons.size(); i++) {
            List<Point2D> above =
                    StreamSupport.stream(polygons.get(i).spliterator(), false)
                            .map(DepthSketches::fromAbove)
                            .toList();
            FigureLook look = PlaneSketches.look(walked, "paint", i);
            figures.add(new BoardPath(above, true, look));
            figures.add(new BoardDot(above.get(i % 2), String.valueOf(i), look));
            targets.add(new Target(LongNode.valueOf(i), QuestionPoints.along(above, true)));
        }
        return new Board(BoardSpace.DEPTH, figures, new NamedPick("paint", targets));
    }

    private static Point2D fromAbove(JsonNode point) {
        return new Point2D.Double(point.path(0).doubleValue(), point.path(2).doubleValue());
    }

    /** Boards below an eye that looks straight down, and the span that is asked for above them. */
    static Board spans(Walked walked) {
        JsonNode faces = walked.input().path("faces");
        JsonNode vertices = walked.input().path("vertices");
        var figures = new ArrayList<BoardFigure>();
        var targets = new ArrayList<Target>();
        double top = 0;
        for (int i = 0; i < faces.size(); i++) {
            List<Point2D> above = new ArrayList<>();
            for (JsonNode vertex : faces.get(i))
                above.add(fromAbove(vertices.path(vertex.intValue())));
            for (Point2D corner : above) top = Math.max(top, corner.getY());
            figures.add(new BoardPath(above, true, PlaneSketches.look(walked, "span", i)));
            figures.add(new BoardDot(above.get(i % 2), String.valueOf(i), FigureLook.GIVEN));
            targets.add(new Target(LongNode.valueOf(i), QuestionPoints.along(above, true)));
        }
        double middle = walked.input().path("size").path(0).doubleValue() / 2;
        for (int i = 0; i < walked.steps().size(); i++)
            figures.add(span(walked.steps().get(i), middle, top, walked.look(i)));
        figures.add(span(walked.given(), middle, top, FigureLook.ASKED));
        return new Board(BoardSpace.DEPTH, figures, new NamedPick("span", targets));
    }

    /** The pixels of a span above the boards; nothing where none is told. */
    private static BoardPath span(JsonNode step, double middle, double top, FigureLook look) {
        if (!step.path("from").isNumber()) return new BoardPath(List.of(), false, look);
        double y = top + 1;
        return new BoardPath(
                List.of(
                        new Point2D.Double(step.path("from").doubleValue() - middle, y),
                        new Point2D.Double(step.path("to").doubleValue() - middle, y)),
                false,
                look);
    }
}
