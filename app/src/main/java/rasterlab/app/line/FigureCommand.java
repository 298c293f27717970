package rasterlab.app.line;

import java.util.Optional;

/** The shell command that draws what the lab shows. */
final class FigureCommand {
    private FigureCommand() {}

    private static String brightness(FigureScene scene) {
        String methods =
                scene.comparison().isEmpty() || scene.comparison().equals(scene.method())
                        ? scene.method()
                        : scene.method() + "," + scene.comparison();
        return "./lab chart line-brightness --methods %s --out line-brightness.png"
                .formatted(methods);
    }

    /** Empty where no command draws the figure. */
    static Optional<String> of(FigureScene scene) {
        if (scene.mode() == LineMode.BRIGHTNESS) return Optional.of(brightness(scene));
        if (!(scene.figure() instanceof ArcFigure arc)) return Optional.empty();
        String radii =
                arc.round()
                        ? "\"radius\": %d".formatted(arc.radiusX())
                        : "\"rx\": %d, \"ry\": %d".formatted(arc.radiusX(), arc.radiusY());
        return Optional.of(
                "echo '{\"center\": [%d, %d], %s}' | ./lab run %s %s"
                        .formatted(
                                arc.centreX(),
                                arc.centreY(),
                                radii,
                                scene.mode().code(),
                                scene.method()));
    }
}
