package rasterlab.app.practice;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Field;
import rasterlab.engine.study.Topic;

/**
 * Finds the sketch of a topic by the fields of its inputs: the one that draws most of them. Topics
 * whose fields none draws are asked in words.
 *
 * @param fields names of those that the sketch draws, which an input must have all
 */
record Sketches(Set<String> fields, Sketch sketch) {
    static final List<Sketches> ALL =
            List.of(
                    new Sketches(Set.of("from", "to", "window"), PixelSketches::line),
                    new Sketches(Set.of("center", "radius"), PixelSketches::circle),
                    new Sketches(Set.of("center", "rx", "ry"), PixelSketches::ellipse),
                    new Sketches(Set.of("picture", "seed"), RowSketches::fill),
                    new Sketches(Set.of("polygon", "rule", "size"), RowSketches::polygon),
                    new Sketches(Set.of("polygon"), PlaneSketches::triangulate),
                    new Sketches(Set.of("polygon", "points"), PlaneSketches::inPolygon),
                    new Sketches(Set.of("triangle", "points"), PlaneSketches::inTriangle),
                    new Sketches(Set.of("kind", "points", "flatness"), PlaneSketches::curve),
                    new Sketches(Set.of("window", "segments"), ClipSketches::segment),
                    new Sketches(Set.of("window", "polygon"), ClipSketches::polygon),
                    new Sketches(Set.of("triangles", "size"), PixelSketches::depths),
                    new Sketches(Set.of("polygons", "eye"), DepthSketches::order),
                    new Sketches(Set.of("vertices", "faces", "size"), DepthSketches::spans),
                    new Sketches(Set.of("zmin", "segments"), NumberSketches::volume),
                    new Sketches(Set.of("points", "degrees", "times"), NumberSketches::turns),
                    new Sketches(Set.of("x", "y", "ends"), NumberSketches::knots),
                    new Sketches(Set.of("picture", "pixels"), NumberSketches::texels),
                    new Sketches(Set.of("vertices", "faces", "eye"), SpaceSketches::faces),
                    new Sketches(Set.of("vertices", "triangles"), SpaceSketches::faces),
                    new Sketches(Set.of("corners", "normals", "points"), SpaceSketches::litFace),
                    new Sketches(Set.of("matrices", "points"), SpaceSketches::points),
                    new Sketches(Set.of("through", "direction", "points"), SpaceSketches::points),
                    new Sketches(Set.of("points", "theta", "phi", "rho"), SpaceSketches::eye));

    static Optional<Sketch> of(String topic) {
        return drawing(Topics.named(topic)).map(Sketches::sketch);
    }

    static Optional<Sketches> drawing(Topic<?, ?, ?> topic) {
        Set<String> given =
                topic.format().input().stream().map(Field::name).collect(Collectors.toSet());
        return ALL.stream()
                .filter(one -> given.containsAll(one.fields))
                .max(Comparator.comparingInt(one -> one.fields.size()));
    }
}
