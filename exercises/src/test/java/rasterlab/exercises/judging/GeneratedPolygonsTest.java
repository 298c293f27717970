package rasterlab.exercises.judging;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.topic.TopicGradings;

/** Where an exercise promises simple polygons, no seed draws another one. */
class GeneratedPolygonsTest {
    private static final long SEEDS = 60;

    private record Side(double x0, double y0, double x1, double y1) {
        boolean meets(Side other) {
            return Line2D.linesIntersect(x0, y0, x1, y1, other.x0, other.y0, other.x1, other.y1);
        }
    }

    @ParameterizedTest(name = "a polygon of {0} crosses itself")
    @ValueSource(strings = {"triangulate", "clip-polygon"})
    void drawnPolygonsAreSimple(String id) throws Exception {
        Exercise exercise = Catalogue.builtIn().named(id);
        TopicGrading grading = TopicGradings.of(exercise);
        for (long seed = 1; seed <= SEEDS; seed++)
            for (Exercise.Case one : exercise.cases())
                for (var call : grading.calls(one, exercise.tolerance(), seed)) {
                    JsonNode input = new ObjectMapper().readTree(call.scene()).path("input");
                    String place = one.name() + ", seed " + seed + ": " + input;
                    assertTrue(isSimple(sides(input.path("polygon"))), place);
                }
    }

    /** A repeated corner makes no side. */
    private static List<Side> sides(JsonNode corners) {
        var sides = new ArrayList<Side>();
        for (int i = 0; i < corners.size(); i++) {
            JsonNode from = corners.get(i);
            JsonNode to = corners.get((i + 1) % corners.size());
            if (!from.equals(to))
                sides.add(
                        new Side(
                                from.get(0).asDouble(),
                                from.get(1).asDouble(),
                                to.get(0).asDouble(),
                                to.get(1).asDouble()));
        }
        return sides;
    }

    /** Whether no two sides meet but neighbours in their common corner. */
    private static boolean isSimple(List<Side> sides) {
        int count = sides.size();
        for (int i = 0; i < count; i++)
            for (int j = i + 2; j < count; j++)
                if ((j + 1) % count != i && sides.get(i).meets(sides.get(j))) return false;
        return count >= 3;
    }
}
