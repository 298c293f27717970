package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
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

/** Bodies and points of space. */
final class SpaceSketches {
    /** How long normals of length 1 are drawn, as a share of the body. */
    private static final double ARROW = 0.3;

    /** Lengths of a direction to each side of the point that a line goes through. */
    private static final double LINE = 4;

    private static final String POINTS = "points";

    private SpaceSketches() {}

    /** A body of faces, the one that is asked for, and sums of normals at its vertices. */
    static Board faces(Walked walked) {
        JsonNode vertices = walked.input().path("vertices");
        JsonNode faces = walked.input().path("faces");
        if (faces.isMissingNode()) faces = walked.input().path("triangles");
        double reach = SpaceView.reach(vertices);
        var figures = new ArrayList<BoardFigure>(SpaceView.axes(1.25 * reach));
        for (JsonNode face : faces) figures.add(face(vertices, face, FigureLook.GIVEN));
        addSums(figures, walked, vertices, reach * ARROW);
        int asked = walked.given().path("face").asInt(-1);
        if (asked >= 0) figures.add(face(vertices, faces.path(asked), FigureLook.ASKED));
        for (int v = 0; v < vertices.size(); v++) {
            boolean about = walked.given().path("vertex").asInt(-1) == v;
            FigureLook look = about ? FigureLook.ASKED : FigureLook.GIVEN;
            figures.add(new BoardDot(SpaceView.at(vertices.get(v)), String.valueOf(v), look));
        }
        JsonNode eye = walked.input().path("eye");
        if (eye.isArray()) {
            figures.add(SpaceView.foot(eye));
            figures.add(new BoardDot(SpaceView.at(eye), "eye", FigureLook.NEWEST));
        }
        return new Board(BoardSpace.SPACE, figures, new NoPick());
    }

    private static BoardPath face(JsonNode vertices, JsonNode face, FigureLook look) {
        List<Point2D> corners = new ArrayList<>();
        for (JsonNode corner : face) corners.add(SpaceView.at(vertices.path(corner.intValue())));
        return new BoardPath(corners, true, look);
    }

    private static void addSums(
            List<BoardFigure> figures, Walked walked, JsonNode vertices, double length) {
        for (int i = 0; i < walked.steps().size(); i++) {
            JsonNode sum = walked.steps().get(i).path("sum");
            JsonNode from = vertices.path(walked.steps().get(i).path("vertex").asInt(-1));
            if (!sum.isMissingNode() && !from.isMissingNode())
                figures.add(SpaceView.arrow(from, sum, length, walked.look(i)));
        }
    }

    /** A lit triangle, the normals at its corners and those that were mixed for its points. */
    static Board litFace(Walked walked) {
        JsonNode corners = walked.input().path("corners");
        JsonNode normals = walked.input().path("normals");
        double reach = SpaceView.reach(corners);
        var figures = new ArrayList<BoardFigure>(SpaceView.axes(1.25 * reach));
        List<Point2D> seen = new ArrayList<>();
        for (JsonNode corner : corners) seen.add(SpaceView.at(corner));
        figures.add(new BoardPath(seen, true, FigureLook.GIVEN));
        for (int i = 0; i < corners.size(); i++) {
            figures.add(
                    SpaceView.arrow(
                            corners.get(i), normals.path(i), ARROW * reach, FigureLook.GIVEN));
            figures.add(new BoardDot(seen.get(i), "abc".substring(i, i + 1), FigureLook.GIVEN));
        }
        for (int i = 0; i < walked.steps().size(); i++) {
            JsonNode step = walked.steps().get(i);
            figures.add(
                    SpaceView.arrow(
                            step.path("place"),
                            step.path("normal"),
                            ARROW * reach,
                            walked.look(i)));
        }
        JsonNode place = walked.given().path("place");
        if (place.isArray()) figures.add(new BoardDot(SpaceView.at(place), "", FigureLook.ASKED));
        return new Board(BoardSpace.SPACE, figures, new NoPick());
    }

    /**
     * A point that goes from step to step, and the line about which it turns, where there is one.
     */
    static Board points(Walked walked) {
        ArrayNode all = JsonNodeFactory.instance.arrayNode();
        all.add(walked.input().path(POINTS).path(0));
        for (JsonNode step : walked.steps()) all.add(step.path(POINTS).path(0));
        var figures = new ArrayList<BoardFigure>(SpaceView.axes(1.1 * SpaceView.reach(all)));
        addLine(figures, walked.input().path("through"), walked.input().path("direction"));
        List<Point2D> way = new ArrayList<>();
        for (JsonNode point : all) way.add(SpaceView.at(point));
        figures.add(new BoardPath(way, false, FigureLook.DONE));
        figures.add(SpaceView.foot(all.get(all.size() - 1)));
        for (int i = 0; i < way.size(); i++) {
            FigureLook look = i == way.size() - 1 ? FigureLook.NEWEST : FigureLook.DONE;
            boolean stays = i > 0 && way.get(i).equals(way.get(i - 1));
            if (!stays || look == FigureLook.NEWEST)
                figures.add(new BoardDot(way.get(i), String.valueOf(i), look));
        }
        walked.wrong()
                .map(answer -> answer.path(POINTS).path(0))
                .filter(JsonNode::isArray)
                .ifPresent(
                        wrong ->
                                figures.add(
                                        new BoardDot(SpaceView.at(wrong), "", FigureLook.WRONG)));
        return new Board(BoardSpace.SPACE, figures, new NoPick());
    }

    private static void addLine(List<BoardFigure> figures, JsonNode through, JsonNode direction) {
        if (!through.isArray()) return;
        List<Point2D> ends = new ArrayList<>();
        for (double side : new double[] {-LINE, LINE})
            ends.add(
                    SpaceView.at(
                            SpaceView.number(through, 0) + side * SpaceView.number(direction, 0),
                            SpaceView.number(through, 1) + side * SpaceView.number(direction, 1),
                            SpaceView.number(through, 2) + side * SpaceView.number(direction, 2)));
        figures.add(new BoardPath(ends, false, FigureLook.GIVEN));
    }

    /** A point, and the eye on its sphere that looks at the origin. */
    static Board eye(Walked walked) {
        JsonNode point = walked.input().path(POINTS).path(0);
        double theta = Math.toRadians(walked.input().path("theta").doubleValue());
        double phi = Math.toRadians(walked.input().path("phi").doubleValue());
        double rho = walked.input().path("rho").doubleValue();
        ArrayNode eye =
                JsonNodeFactory.instance
                        .arrayNode()
                        .add(rho * Math.sin(phi) * Math.cos(theta))
                        .add(rho * Math.sin(phi) * Math.sin(theta))
                        .add(rho * Math.cos(phi));
        var figures = new ArrayList<BoardFigure>(SpaceView.axes(0.75 * rho));
        figures.add(SpaceView.foot(eye));
        figures.add(
                new BoardPath(
                        List.of(SpaceView.at(eye), new Point2D.Double()), false, FigureLook.DONE));
        figures.add(new BoardDot(SpaceView.at(eye), "eye", FigureLook.DONE));
        figures.add(SpaceView.foot(point));
        figures.add(new BoardDot(SpaceView.at(point), "", FigureLook.NEWEST));
        return new Board(BoardSpace.SPACE, figures, new NoPick());
    }
}
