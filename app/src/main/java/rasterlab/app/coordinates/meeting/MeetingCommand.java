package rasterlab.app.coordinates.meeting;

import java.util.Optional;
import rasterlab.app.coordinates.figure.CallJson;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;

/** The shell command that asks the same. */
final class MeetingCommand {
    private MeetingCommand() {}

    /** Empty where the plane's nearest point to the origin is beyond doubles. */
    static Optional<String> of(MeetingChoice choice) {
        Plane plane = choice.plane();
        Vector point;
        try {
            point = choice.point().orElseGet(plane::nearestToOrigin);
        } catch (IllegalArgumentException beyond) {
            return Optional.empty();
        }
        return Optional.of(
                "echo '{\"line\": %s, \"normal\": %s, \"point\": %s}' | ./lab run line-plane %s"
                        .formatted(
                                "["
                                        + numbers(choice.line().from())
                                        + ", "
                                        + numbers(choice.line().through())
                                        + "]",
                                numbers(plane.normal()),
                                numbers(point),
                                choice.method()));
    }

    private static String numbers(Vector v) {
        return "[%s, %s, %s]"
                .formatted(CallJson.number(v.x()), CallJson.number(v.y()), CallJson.number(v.z()));
    }
}
