package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.topic.TopicGradings;

/** The segments that a case has drawn. */
final class TriedSegments {
    private TriedSegments() {}

    static List<Segment> of(Exercise exercise, Case one, long seed) {
        List<Segment> segments = new ArrayList<>();
        LineRasterizer listening =
                (x0, y0, x1, y1, out) -> segments.add(new Segment(x0, y0, x1, y1));
        for (GradedCall call : TopicGradings.named("line").calls(one, exercise.tolerance(), seed))
            call.recorded(listening, call.caps().items());
        return segments;
    }
}
