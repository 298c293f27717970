package rasterlab.app.clip;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import rasterlab.engine.clip.segment.ClipWindow;

/** The shell command that clips what the lab shows. */
final class ClipCommand {
    private ClipCommand() {}

    static String of(ClipScene scene) {
        return "echo '{%s}' | ./lab run %s %s"
                .formatted(input(scene), scene.mode().topic(), scene.method());
    }

    private static String input(ClipScene scene) {
        if (scene instanceof SegmentScene segments)
            return window(segments.window())
                    + ", "
                    + segments(segments.segments().stream().map(PlaneSegment::ends).toList());
        if (scene instanceof PolygonScene polygon)
            return window(polygon.window()) + ", \"polygon\": " + points(polygon.subject());
        var volume = (VolumeScene) scene;
        return "\"zmin\": "
                + number(volume.zmin())
                + ", "
                + segments(volume.segments().stream().map(SpaceSegment::ends).toList());
    }

    private static String window(ShownWindow window) {
        if (!window.upright()) return "\"window\": " + points(window.corners());
        ClipWindow sides = window.rectangle();
        return "\"window\": " + numbers(sides.sides());
    }

    private static String segments(List<double[]> segments) {
        return segments.stream()
                .map(ClipCommand::numbers)
                .collect(Collectors.joining(", ", "\"segments\": [", "]"));
    }

    private static String points(List<Place> points) {
        return points.stream()
                .map(point -> numbers(new double[] {point.x(), point.y()}))
                .collect(Collectors.joining(", ", "[", "]"));
    }

    private static String numbers(double[] numbers) {
        return Arrays.stream(numbers)
                .mapToObj(ClipCommand::number)
                .collect(Collectors.joining(", ", "[", "]"));
    }

    /** All digits that the number has, a whole one without ".0". */
    private static String number(double value) {
        String digits = Double.toString(value);
        return digits.endsWith(".0") ? digits.substring(0, digits.length() - 2) : digits;
    }
}
