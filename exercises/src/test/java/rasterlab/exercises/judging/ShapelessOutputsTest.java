package rasterlab.exercises.judging;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangulation.Triangles;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.Painting;

/** An answer in no form of the contract is wrong, and no fault of the judge. */
class ShapelessOutputsTest {
    private static <I, O> void assertWrong(Topic<?, I, O> topic, I input, O exact, O actual) {
        assertFalse(topic.correct(topic.compare(input, exact, actual)));
        assertDoesNotThrow(() -> Leaves.of(topic.format(), input, actual));
    }

    @Test
    void aPolygonThatThereIsNotIsNoPiece() {
        var topic = new DepthOrderTopic();
        var sight = topic.hazards().get(0).input();
        for (int polygon : new int[] {-1, sight.polygons().length}) {
            var painting = new Painting();
            painting.add(polygon, sight.polygons()[0]);
            assertWrong(topic, sight, topic.exact(sight, topic.mostItems()), painting);
        }
    }

    @Test
    void twoNumbersAreNoCornersOfAPiece() {
        var topic = new DepthOrderTopic();
        var sight = topic.hazards().get(0).input();
        for (double[] corners :
                List.of(
                        new double[0],
                        new double[] {1, 2},
                        new double[] {0, 0, 0, 1, 0, 0, 0, 1, Double.NaN})) {
            var painting = new Painting();
            painting.add(0, corners);
            assertWrong(topic, sight, topic.exact(sight, topic.mostItems()), painting);
        }
    }

    @Test
    void threeNumbersAreNoPolygonInThePlane() {
        var topic = new PolygonClipTopic();
        PolygonInWindow input = topic.hazards().get(0).input();
        for (double[] piece : List.of(new double[0], new double[] {1, 2, 3}))
            assertWrong(
                    topic, input, topic.exact(input, topic.mostItems()), List.<double[]>of(piece));
    }

    /** A smaller polygon, on which a wrong answer is known, may have no area. */
    @Test
    void trianglesInAPolygonWithoutAreaAreComparedToo() {
        var topic = new TriangulateTopic();
        var line = Points.of(0, 0, 1, 0, 2, 0, 3, 0);
        assertWrong(topic, line, new Triangles(0, 1, 2), new Triangles(0, 2, 3));
    }
}
