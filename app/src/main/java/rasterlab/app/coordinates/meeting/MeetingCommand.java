package rasterlab.app.coordinates.meeting;

import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.geometry.meeting.PlaneAndLines;

/** The shell command that asks the same. */
final class MeetingCommand {
    private MeetingCommand() {}

    /** The command; empty where the plane's nearest point to the origin is beyond doubles. */
    static Optional<String> of(MeetingChoice choice) {
        Plane plane = choice.plane();
        Vector point;
        try {
            point = choice.point().orElseGet(plane::nearestToOrigin);
        } catch (IllegalArgumentException beyond) {
            return Optional.empty();
        }
        var input = new PlaneAndLines(plane, Optional.of(point), List.of(choice.line()));
        return Optional.of(
                "echo '%s' | ./lab run line-plane %s"
                        .formatted(
                                CommandInput.of(new LinePlaneTopic().format(), input),
                                choice.method()));
    }
}
