package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.practice.Board.Dot;
import rasterlab.app.practice.Board.Figure;
import rasterlab.app.practice.Board.Look;
import rasterlab.app.practice.Board.None;
import rasterlab.app.practice.Board.Path;
import rasterlab.app.practice.Board.Space;
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
        var figures = new ArrayList<Figure>(SpaceView.axes(1.25 * reach));
        for (JsonNode face : faces) figures.add(face(vertices, face, Look.GIVEN));
        addSums(figures, walked, vertices, reach * ARROW);
        int asked = walked.told().path("face").asInt(-1);
        if (asked >= 0) figures.add(face(vertices, faces.path(asked), Look.ASKED));
        for (int v = 0; v < vertices.size(); v++) {
            boolean about = walked.told().path("vertex").asInt(-1) == v;
            Look look = about ? Look.ASKED : Look.GIVEN;
            figures.add(new Dot(SpaceView.at(vertices.get(v)), String.valueOf(v), look));
        }
        JsonNode eye = walked.input().path("eye");
        if (eye.isArray()) {
            figures.add(SpaceView.foot(eye));
            figures.add(new Dot(SpaceView.at(eye), "eye", Look.NEWEST));
        }
        return new Board(Space.SPACE, figures, new None());
    }

    private static Path face(JsonNode vertices, JsonNode face, Look look) {
        List<Point2D> corners = new ArrayList<>();
        for (JsonNode corner : face) corners.add(SpaceView.at(vertices.path(corner.intValue())));
        return new Path(corners, true, look);
    }

    private static void addSums(
            List<Figure> figures, Walked walked, JsonNode vertices, double length) {
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
        var figures = new ArrayList<Figure>(SpaceView.axes(1.25 * reach));
        List<Point2D> seen = new ArrayList<>();
        for (JsonNode corner : corners) seen.add(SpaceView.at(corner));
        figures.add(new Path(seen, true, Look.GIVEN));
        for (int i = 0; i < corners.size(); i++) {
            figures.add(
                    SpaceView.arrow(corners.get(i), normals.path(i), ARROW * reach, Look.GIVEN));
            figures.add(new Dot(seen.get(i), "abc".substring(i, i + 1), Look.GIVEN));
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
        JsonNode place = walked.told().path("place");
        if (place.isArray()) figures.add(new Dot(SpaceView.at(place), "", Look.ASKED));
        return new Board(Space.SPACE, figures, new None());
    }

    /**
     * A point that goes from step to step, and the line about which it turns, where there is one.
     */
    static Board points(Walked walked) {
        ArrayNode all = JsonNodeFactory.instance.arrayNode();
        all.add(walked.input().path(POINTS).path(0));
        for (JsonNode step : walked.steps()) all.add(step.path(POINTS).path(0));
        var figures = new ArrayList<Figure>(SpaceView.axes(1.1 * SpaceView.reach(all)));
        addLine(figures, walked.input().path("through"), walked.input().path("direction"));
        List<Point2D> way = new ArrayList<>();
        for (JsonNode point : all) way.add(SpaceView.at(point));
        figures.add(new Path(way, false, Look.DONE));
        figures.add(SpaceView.foot(all.get(all.size() - 1)));
        for (int i = 0; i < way.size(); i++) {
            Look look = i == way.size() - 1 ? Look.NEWEST : Look.DONE;
            boolean stays = i > 0 && way.get(i).equals(way.get(i - 1));
            if (!stays || look == Look.NEWEST)
                figures.add(new Dot(way.get(i), String.valueOf(i), look));
        }
        walked.wrong()
                .map(answer -> answer.path(POINTS).path(0))
                .filter(JsonNode::isArray)
                .ifPresent(wrong -> figures.add(new Dot(SpaceView.at(wrong), "", Look.WRONG)));
        return new Board(Space.SPACE, figures, new None());
    }

    private static void addLine(List<Figure> figures, JsonNode through, JsonNode direction) {
        if (!through.isArray()) return;
        List<Point2D> ends = new ArrayList<>();
        for (double side : new double[] {-LINE, LINE})
            ends.add(
                    SpaceView.at(
                            SpaceView.number(through, 0) + side * SpaceView.number(direction, 0),
                            SpaceView.number(through, 1) + side * SpaceView.number(direction, 1),
                            SpaceView.number(through, 2) + side * SpaceView.number(direction, 2)));
        figures.add(new Path(ends, false, Look.GIVEN));
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
        var figures = new ArrayList<Figure>(SpaceView.axes(0.75 * rho));
        figures.add(SpaceView.foot(eye));
        figures.add(new Path(List.of(SpaceView.at(eye), new Point2D.Double()), false, Look.DONE));
        figures.add(new Dot(SpaceView.at(eye), "eye", Look.DONE));
        figures.add(SpaceView.foot(point));
        figures.add(new Dot(SpaceView.at(point), "", Look.NEWEST));
        return new Board(Space.SPACE, figures, new None());
    }
}
