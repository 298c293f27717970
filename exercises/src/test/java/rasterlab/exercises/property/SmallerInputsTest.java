package rasterlab.exercises.property;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.property.SmallerInputs.SmallerInput;

class SmallerInputsTest {
    private static final JsonMapper MAPPER = new JsonMapper();
    private static final long SEED = 20261127;

    private static List<String> of(String json) throws JsonProcessingException {
        return SmallerInputs.of(SmallerInput.first(MAPPER.readTree(json)))
                .map(one -> one.json().toString())
                .toList();
    }

    @Test
    void membersGoInHalvesThenOneByOne() throws JsonProcessingException {
        assertEquals(
                List.of("{\"a\":[0,0]}", "{\"a\":[0,0]}"), of("{\"a\":[0,0,0,0]}").subList(0, 2));
        assertTrue(of("{\"a\":[[0],[0],[0]]}").contains("{\"a\":[[0],[0]]}"));
    }

    @Test
    void numbersAreRoundedHalvedAndBroughtNearerToZero() throws JsonProcessingException {
        assertEquals(
                List.of("{\"a\":7}", "{\"a\":3}", "{\"a\":0}", "{\"a\":7}", "{\"a\":3}"),
                of("{\"a\":7.25}"));
        assertEquals(
                List.of("{\"a\":-3}", "{\"a\":0}", "{\"a\":-3}", "{\"a\":-6}"), of("{\"a\":-7}"));
        assertTrue(of("{\"a\":\"on\",\"b\":true,\"c\":0}").isEmpty());
    }

    @Test
    void itEndsHoweverOftenItIsDone() throws JsonProcessingException {
        Random random = new Random(SEED);
        for (int start = 0; start < 50; start++) {
            JsonNode one =
                    MAPPER.readTree(
                            "{\"a\":[%s,%s],\"b\":%s}"
                                    .formatted(
                                            random.nextGaussian() * 100,
                                            random.nextInt(9) - 4,
                                            random.nextDouble()));
            int steps = 0;
            SmallerInput at = SmallerInput.first(one);
            for (List<SmallerInput> next = SmallerInputs.of(at).toList();
                    !next.isEmpty();
                    next = SmallerInputs.of(at).toList()) {
                // The last one takes the smallest step.
                int chosen = start % 2 == 0 ? random.nextInt(next.size()) : next.size() - 1;
                at = next.get(chosen);
                assertTrue(steps++ < 1000, "seed " + SEED + ", at " + at);
            }
        }
    }
}
