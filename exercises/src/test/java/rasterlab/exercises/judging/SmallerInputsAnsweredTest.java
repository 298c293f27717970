package rasterlab.exercises.judging;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.property.SmallerInputs;
import rasterlab.exercises.property.SmallerInputs.SmallerInput;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Inputs that are made smaller have a right answer, or are refused: nothing breaks down on them.
 */
class SmallerInputsAnsweredTest {
    private static final int MOST_OF_A_HAZARD = 25;
    private static final int LONGEST = 600;

    static Stream<String> topics() {
        return TopicGradings.names().stream();
    }

    @DisplayName("the exact answer breaks down on a smaller input")
    @ParameterizedTest(name = "{0}")
    @MethodSource("topics")
    void eachIsAnsweredOrRefused(String name) {
        assertEquals(List.of(), broken(Topics.named(name)));
    }

    private static <C, I, O> List<String> broken(Topic<C, I, O> topic) {
        List<String> broken = new ArrayList<>();
        for (Hazard<I> hazard : topic.hazards()) {
            Optional<JsonNode> input = inputJson(topic, hazard.input());
            if (input.isEmpty()) continue;
            SmallerInputs.of(SmallerInput.first(input.get()))
                    .limit(MOST_OF_A_HAZARD)
                    .forEach(one -> answer(topic, one.json(), broken));
        }
        return broken;
    }

    /** The input as JSON; empty where it is long, or cannot be told so. */
    private static <C, I, O> Optional<JsonNode> inputJson(Topic<C, I, O> topic, I input) {
        try {
            return Optional.of(Leaves.tree(topic.format(), input))
                    .filter(one -> one.toString().length() <= LONGEST);
        } catch (IllegalArgumentException untold) {
            return Optional.empty();
        }
    }

    private static <C, I, O> void answer(Topic<C, I, O> topic, JsonNode json, List<String> broken) {
        try {
            TopicInputs.read(topic.format(), json).ifPresent(input -> topic.exact(input, 100));
        } catch (IllegalArgumentException refused) {
            return;
        } catch (RuntimeException failed) {
            broken.add(json + ": " + failed);
        }
    }
}
