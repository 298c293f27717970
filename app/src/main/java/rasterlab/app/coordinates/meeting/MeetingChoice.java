package rasterlab.app.coordinates.meeting;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.geometry.meeting.PlaneAndLines;

/**
 * The user's choice, which undo brings back.
 *
 * @param plane n·p = c
 * @param point of the plane, where one is known: n·p = c need not hold there, as c is rounded
 * @param line p₁ + μ·(p₂ − p₁)
 */
public record MeetingChoice(String method, Plane plane, Optional<Vector> point, Line line) {
    static MeetingChoice first() {
        Plane plane = Plane.through(new Vector(1, 0, 0), new Vector(0, 2, 0), new Vector(0, 0, 3));
        return new MeetingChoice(
                "formula",
                plane,
                Optional.empty(),
                new Line(new Vector(0, 0, 0), new Vector(1, 2, 3)));
    }

    MeetingChoice withMethod(String other) {
        return new MeetingChoice(other, plane, point, line);
    }

    MeetingChoice with(Line other) {
        return new MeetingChoice(method, plane, point, other);
    }

    /** The first of the lines. */
    MeetingChoice with(PlaneAndLines input) {
        return new MeetingChoice(method, input.plane(), input.pointOfPlane(), input.line(0));
    }

    PlaneAndLines input() {
        return new PlaneAndLines(plane, point, List.of(line));
    }
}
