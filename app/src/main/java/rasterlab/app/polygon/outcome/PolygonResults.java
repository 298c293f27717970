package rasterlab.app.polygon.outcome;

import java.util.Optional;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.figure.SeedFigure;

/**
 * The results for one scene.
 *
 * @param outcome of the chosen method
 * @param other of the second method, if one is compared
 */
public record PolygonResults(
        PolygonScene scene, MethodOutcome outcome, Optional<MethodOutcome> other) {
    public static PolygonResults of(PolygonTopics topics, PolygonScene scene) {
        Optional<MethodOutcome> other =
                scene.comparison().isEmpty()
                        ? Optional.empty()
                        : Optional.of(outcome(topics, scene.withMethod(scene.comparison())));
        return new PolygonResults(scene, outcome(topics, scene), other);
    }

    private static MethodOutcome outcome(PolygonTopics topics, PolygonScene scene) {
        PolygonFigure figure = scene.figure();
        if (figure instanceof InsideFigure inside)
            return Judging.of(topics, scene.mode(), inside, scene.method());
        if (figure instanceof CutFigure cut)
            return Cutting.of(topics.own().in(topics.triangulation()), cut, scene.method());
        if (figure instanceof FillFigure fill)
            return ScanFilling.of(topics.own().in(topics.fill()), fill, scene.method());
        return SeedFilling.of(topics.own().in(topics.seed()), (SeedFigure) figure, scene.method());
    }
}
