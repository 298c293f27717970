package rasterlab.app.coordinates.meeting;

import java.util.List;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.geometry.meeting.PlaneAndLines;

/**
 * What the user chose, and what undo brings back.
 *
 * @param plane n·p = c
 * @param line p₁ + μ·(p₂ − p₁)
 */
public record MeetingChoice(String method, Plane plane, Line line) {
    static MeetingChoice first() {
        Plane plane = Plane.through(new Vector(1, 0, 0), new Vector(0, 2, 0), new Vector(0, 0, 3));
        return new MeetingChoice(
                "formula", plane, new Line(new Vector(0, 0, 0), new Vector(1, 2, 3)));
    }

    MeetingChoice withMethod(String other) {
        return new MeetingChoice(other, plane, line);
    }

    MeetingChoice with(Line other) {
        return new MeetingChoice(method, plane, other);
    }

    /** The first of the lines. */
    MeetingChoice with(PlaneAndLines input) {
        return new MeetingChoice(method, input.plane(), input.line(0));
    }

    PlaneAndLines input() {
        return new PlaneAndLines(plane, List.of(line));
    }
}
