package rasterlab.app.polygon;

import java.util.Optional;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.polygon.figure.CornerList;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.polygon.inside.PointInPolygonTopic;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;

/** The shell command that does what the lab shows. */
final class PolygonCommand {
    /** A larger picture is too long for a command. */
    private static final int MOST_PIXELS = 10_000;

    private PolygonCommand() {}

    /**
     * The command; empty where none takes the figure, such as one with a corner that is nowhere.
     */
    static Optional<String> of(PolygonScene scene) {
        if (scene.figure() instanceof SeedFigure seed && seed.width() * seed.height() > MOST_PIXELS)
            return Optional.empty();
        if (!scene.figure().grips().values().stream().allMatch(PolygonPoint::isFinite))
            return Optional.empty();
        return Optional.of(
                "echo '%s' | ./lab run %s %s"
                        .formatted(
                                input(scene.figure()),
                                scene.mode().topic(),
                                OwnWords.known(
                                        scene.method(), scene.comparison(), scene.mode().topic())));
    }

    private static String input(PolygonFigure figure) {
        if (figure instanceof InsideFigure inside)
            return inside.triangle()
                    ? CommandInput.signed(new PointInTriangleTopic().format(), inside.input())
                    : CommandInput.signed(new PointInPolygonTopic().format(), inside.input());
        if (figure instanceof CutFigure cut)
            return CommandInput.signed(
                    new TriangulateTopic().format(), CornerList.points(cut.corners()));
        if (figure instanceof FillFigure fill)
            return CommandInput.signed(new PolygonFillTopic().format(), fill.task());
        return CommandInput.signed(new FillTopic().format(), ((SeedFigure) figure).task());
    }
}
