package rasterlab.engine.border;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;

/**
 * Methods that promise to be right are right on numbers at the borders of doubles.
 *
 * <p>Each is tried on 2,000 inputs, on 1,000,000 with {@code -Drasterlab.full=true}, beginning with
 * the seed of {@code -Drasterlab.seed}. Topics with a slow reference are tried on fewer, as {@link
 * Borders} says.
 */
@Tag("slow")
class BorderTest {
    private static final int INPUTS = Boolean.getBoolean("rasterlab.full") ? 1_000_000 : 2_000;
    private static final long SEED = Long.getLong("rasterlab.seed", 28);

    static Stream<Border<?, ?, ?>> borders() {
        return Borders.all();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("borders")
    void methodsThatPromiseToBeRightAreRightAtTheBorders(Border<?, ?, ?> border) {
        assertRight(border);
    }

    private static <C, I, O> void assertRight(Border<C, I, O> border) {
        int count = (int) Math.ceil(INPUTS * border.share());
        var trial = new BorderTrial<>(border);
        assertEquals("", String.join("\n", trial.failures(SEED, count)));
        assertTrue(
                trial.meant(count),
                () ->
                        "too few of %s inputs were judged: %s, seed %s"
                                .formatted(count, trial.counted(), SEED));
    }

    @Test
    void everyTopicWithAMethodThatPromisesToBeRightHasBorders() {
        var tried = Borders.byTopic().keySet();
        assertEquals(
                Set.of(),
                Topics.all().stream()
                        .filter(
                                topic ->
                                        topic.methods().stream()
                                                .anyMatch(Method::promisesToBeRight))
                        .map(topic -> topic.name())
                        .filter(name -> !tried.contains(name))
                        .collect(Collectors.toSet()));
    }
}
