package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.topic.TopicGradings;

/** A case may ask for a hazard by its name wherever a report can show its input. */
class HazardCasesTest {
    static List<String> topics() {
        return TopicGradings.names();
    }

    private static Case asking(String hazard) {
        return new Case(
                hazard,
                Map.of(),
                Criterion.STABILITY,
                Disclosure.OPEN,
                1,
                "{\"hazard\":\"" + hazard + "\"}",
                false);
    }

    @ParameterizedTest(name = "a hazard of {0} is taken, and yet no report can show it")
    @MethodSource("topics")
    void whatIsTakenIsShown(String topic) {
        TopicGrading grading = TopicGradings.named(topic);
        List<String> taken = new ArrayList<>();
        for (Hazard<?> one : Topics.named(topic).hazards())
            for (GradedCall call : calls(grading, one.name())) {
                if (taken.isEmpty())
                    assertTrue(call.scene(Optional.empty()).contains(topic), one.name());
                taken.add(one.name());
                assertFalse(call.input().isEmpty(), one.name());
            }
        assertFalse(taken.isEmpty());
    }

    private static List<GradedCall> calls(TopicGrading grading, String hazard) {
        try {
            return grading.calls(asking(hazard), new ExerciseTolerance(false), 1);
        } catch (CatalogueException untold) {
            assertTrue(untold.in("en").contains("field 'input'"), untold.in("en"));
            return List.of();
        }
    }

    @Test
    void colorsThatAreToldOneByOneAreAskedForSo() {
        TopicGrading grading = TopicGradings.named("color");
        List<GradedCall> calls = calls(grading, "pure-colours");
        assertEquals(6, calls.size());
        Object right = Topics.named("color").methods().get(0).implementation();
        for (GradedCall call : calls)
            assertTrue(
                    call.judge(GradedMethod.answer(call, right)).right(), call.input().toString());
    }
}
