package rasterlab.app.practice;

import java.util.Map;
import java.util.Optional;

/** The sketch of each topic whose questions have a picture; the others are asked in words. */
final class Sketches {
    private static final Map<String, Sketch> ALL =
            Map.ofEntries(
                    Map.entry("line", PixelSketches::line),
                    Map.entry("circle", PixelSketches::circle),
                    Map.entry("ellipse", PixelSketches::ellipse),
                    Map.entry("fill", RowSketches::fill),
                    Map.entry("polygon-fill", RowSketches::polygon),
                    Map.entry("triangulate", PlaneSketches::triangulate),
                    Map.entry("point-in-polygon", PlaneSketches::inPolygon),
                    Map.entry("point-in-triangle", PlaneSketches::inTriangle),
                    Map.entry("curve", PlaneSketches::curve),
                    Map.entry("clip-segment", ClipSketches::segment),
                    Map.entry("clip-polygon", ClipSketches::polygon),
                    Map.entry("depth-triangle", PixelSketches::depths),
                    Map.entry("depth-order", DepthSketches::order),
                    Map.entry("hidden-surfaces", DepthSketches::spans));

    private Sketches() {}

    static Optional<Sketch> of(String topic) {
        return Optional.ofNullable(ALL.get(topic));
    }
}
