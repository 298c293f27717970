package rasterlab.app.line.figure;

import java.util.Optional;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.line.trace.LineMode;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.CircleTopic;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.circle.EllipseTopic;

/** The shell command that draws what the lab shows. */
public final class FigureCommand {
    private FigureCommand() {}

    private static String brightness(FigureScene scene) {
        String methods =
                scene.comparison().isEmpty() || scene.comparison().equals(scene.method())
                        ? scene.method()
                        : scene.method() + "," + scene.comparison();
        return "./lab chart line-brightness --methods %s --out line-brightness.png"
                .formatted(methods);
    }

    /** The command; empty where none draws the figure. */
    public static Optional<String> of(FigureScene scene) {
        if (scene.mode() == LineMode.BRIGHTNESS) return Optional.of(brightness(scene));
        if (!(scene.figure() instanceof ArcFigure arc)) return Optional.empty();
        return Optional.of(
                "echo '%s' | ./lab run %s %s"
                        .formatted(
                                input(arc),
                                scene.mode().code(),
                                OwnWords.known(
                                        scene.method(), scene.comparison(), scene.mode().code())));
    }

    private static String input(ArcFigure arc) {
        int x = arc.centerX();
        int y = arc.centerY();
        return arc.round()
                ? CommandInput.of(new CircleTopic().format(), new Circle(x, y, arc.radiusX()))
                : CommandInput.of(
                        new EllipseTopic().format(),
                        new Ellipse(x, y, arc.radiusX(), arc.radiusY()));
    }
}
