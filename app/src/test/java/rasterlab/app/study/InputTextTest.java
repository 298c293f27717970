package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rasterlab.engine.Topics;
import rasterlab.engine.line.Segment;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

class InputTextTest {
    private record Pair(String name, List<double[]> points) {}

    @Test
    void recordsAreWrittenByTheirComponents() {
        assertEquals(
                "name = a\npoints = [[1.0, 2.5]]",
                InputText.of(new Pair("a", List.of(new double[] {1, 2.5}))));
    }

    @Test
    void recordThatSpeaksForItselfIsLeftToIt() {
        assertEquals("(1, 2)→(3, 4)", InputText.of(new Segment(1, 2, 3, 4)));
    }

    @Test
    void longListsAreCutWithTheirLength() {
        String text = InputText.of(IntStream.range(0, 1000).boxed().toList());
        assertTrue(text.endsWith("23, … (1000)]"), text);
    }

    @Test
    void noInputOfAnyHazardIsShownByItsAddress() {
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards()) {
                String text = InputText.of(hazard.input());
                assertFalse(
                        text.matches("(?s).*(\\[[DIJ]|[a-z]\\.[A-Z]\\w*)@[0-9a-f]+.*"),
                        topic.name() + ", " + hazard.name() + ": " + text);
            }
    }
}
