package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.topic.TopicGradings;

class ClaimedMistakesTest {
    private static final long SEED = 20261127;

    @Test
    @DisplayName("pixels that are sent twice cost points in cases that ask for something else")
    void pixelsOnTheAxesSentTwiceCostTheirOwnCasesAlone() {
        Exercise circle = Catalogue.builtIn().named("circle");
        Object textbook = Topics.named("circle").method("bresenham-textbook").implementation();
        GradedMethod tried =
                GradedMethod.on(
                        circle,
                        GradedMethod.calls(circle, TopicGradings.of(circle), SEED),
                        textbook);
        List<String> own =
                circle.cases().stream()
                        .filter(one -> circle.group(one).orElseThrow().name().equals("once"))
                        .map(Case::name)
                        .toList();
        assertEquals(own, tried.failed());
    }
}
