package rasterlab.app.polygon;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import rasterlab.contract.FillRule;
import rasterlab.engine.fill.FillTask;

/** The shell command that does what the lab shows. */
final class PolygonCommand {
    /** A larger picture is too long for a command. */
    private static final int MOST_PIXELS = 10_000;

    private PolygonCommand() {}

    /** Empty where no command takes the figure, such as one with a corner that is nowhere. */
    static Optional<String> of(PolygonScene scene) {
        if (scene.figure() instanceof SeedFigure seed && seed.width() * seed.height() > MOST_PIXELS)
            return Optional.empty();
        if (!scene.figure().grips().values().stream().allMatch(Place::isFinite))
            return Optional.empty();
        return Optional.of(
                "echo '{%s}' | ./lab run %s %s"
                        .formatted(input(scene), scene.mode().topic(), scene.method()));
    }

    private static String input(PolygonScene scene) {
        if (scene.figure() instanceof InsideFigure inside)
            return "\"%s\": %s, \"points\": %s"
                    .formatted(
                            inside.triangle() ? "triangle" : "polygon",
                            points(inside.corners()),
                            points(inside.points()));
        if (scene.figure() instanceof CutFigure cut) return polygon(cut.corners());
        if (scene.figure() instanceof FillFigure fill)
            return "%s, \"rule\": \"%s\", \"size\": [%d, %d]"
                    .formatted(
                            polygon(fill.corners()),
                            fill.rule() == FillRule.EVEN_ODD ? "evenodd" : "nonzero",
                            fill.width(),
                            fill.height());
        return seed(((SeedFigure) scene.figure()).task());
    }

    private static String seed(FillTask task) {
        return "\"picture\": %s, \"seed\": [%d, %d], \"with\": \"%s\", \"connectivity\": %d"
                .formatted(
                        task.rows().stream().collect(Collectors.joining("\", \"", "[\"", "\"]")),
                        task.x(),
                        task.y(),
                        Character.toString(task.with()),
                        task.connectivity());
    }

    private static String polygon(List<Place> corners) {
        return "\"polygon\": " + points(corners);
    }

    private static String points(List<Place> points) {
        return points.stream()
                .map(point -> "[" + number(point.x()) + ", " + number(point.y()) + "]")
                .collect(Collectors.joining(", ", "[", "]"));
    }

    /** All digits that the number has, a whole one without ".0". */
    private static String number(double value) {
        String digits = Double.toString(value);
        return digits.endsWith(".0") ? digits.substring(0, digits.length() - 2) : digits;
    }
}
