package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/** What {@code --steps} adds, for every method that has steps. */
class RunStepsTest {
    /** Their steps are matrices applied one after the other; nothing is decided. */
    private static final List<String> UNDECIDED = List.of("transform", "rotate-axis");

    static Stream<String> topics() {
        return Topics.all().stream().map(Topic::name).filter(name -> !UNDECIDED.contains(name));
    }

    @ParameterizedTest(name = "a step of {0} has no decision value, or the value no formula")
    @MethodSource("topics")
    void everyStepHasItsDecision(String topic) throws Exception {
        for (var method : Topics.named(topic).methods()) {
            Ran ran = stepped(topic, method.name());
            if (ran.err().contains("has no steps") || ran.err().contains("does not end")) continue;
            ran.assertDone();
            JsonNode answer = new ObjectMapper().readTree(ran.out());
            assertFalse(answer.path("decision").asText().isEmpty(), ran.out());
            assertFalse(answer.path("steps").isEmpty(), ran.out());
            for (JsonNode step : answer.path("steps"))
                for (JsonNode one : step.isArray() ? step : List.of(step))
                    assertTrue(one.has("decision"), method.name() + ": " + one);
        }
    }

    private static Ran stepped(String topic, String method) {
        return Ran.labReading(RunExamples.of(topic), "run", topic, method, "--steps");
    }

    @ParameterizedTest(name = "--steps changes the answer of {0}")
    @MethodSource("topics")
    void theAnswerIsTheSameWithItsSteps(String topic) throws Exception {
        for (var method : Topics.named(topic).methods()) {
            Ran ran = stepped(topic, method.name());
            if (ran.exitCode() != 0) continue;
            JsonNode plain =
                    new ObjectMapper()
                            .readTree(
                                    Ran.labReading(
                                                    RunExamples.of(topic),
                                                    "run",
                                                    topic,
                                                    method.name())
                                            .out());
            JsonNode answer = new ObjectMapper().readTree(ran.out());
            plain.fieldNames()
                    .forEachRemaining(
                            name -> assertEquals(plain.get(name), answer.get(name), method.name()));
        }
    }

    @Test
    void cutIsDecidedByItsDiagonalAndAClippedPolygonByItsCorners() {
        assertTrue(
                stepped("triangulate", "shortest-diagonal")
                        .out()
                        .contains("{\"cut\":0,\"diagonal\":[3,1],\"decision\":25.0}"));
        assertTrue(
                stepped("clip-polygon", "sutherland-hodgman")
                        .out()
                        .contains("{\"at\":\"side 1\",\"decision\":4,\"polygon\":["));
    }
}
