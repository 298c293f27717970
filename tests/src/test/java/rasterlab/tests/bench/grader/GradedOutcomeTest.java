package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GradedOutcomeTest {
    private static final GradedOutcome RIGHT = new GradedOutcome("ok", 6, 3);

    @Test
    @DisplayName("accuracy is taken for stability")
    void readsWhatTheApiTells() throws Exception {
        String graded =
                "{\"verdict\":\"ok\",\"points\":{\"accuracy\":6,\"stability\":3,\"speed\":1}}";
        assertEquals(RIGHT, GradedOutcome.of(new ObjectMapper().readTree(graded)));
    }

    @Test
    @DisplayName("a submission without a result has one")
    void anUngradedOneHasNoVerdict() throws Exception {
        String waiting = "{\"verdict\":null,\"points\":null,\"state\":\"queued\"}";
        GradedOutcome none = GradedOutcome.of(new ObjectMapper().readTree(waiting));
        assertEquals(List.of("a: ok 6 + 3 ≠ none 0 + 0"), compared(none));
    }

    @ParameterizedTest(name = "a result of {0} {1} + {2} is called equal to one of ok 6 + 3")
    @CsvSource({"internal, 6, 3", "ok, 5, 3", "ok, 6, 2"})
    void tellsWhatDiffers(String verdict, int accuracy, int stability) {
        var other = new GradedOutcome(verdict, accuracy, stability);
        assertEquals(List.of("a: ok 6 + 3 ≠ " + other.text()), compared(other));
    }

    @Test
    @DisplayName("a result that is missing is called equal")
    void tellsWhatIsMissing() {
        assertEquals(
                List.of("b: ok 6 + 3 ≠ -"),
                GradedOutcome.differences(Map.of("a", RIGHT, "b", RIGHT), Map.of("a", RIGHT)));
    }

    @Test
    @DisplayName("equal results are told as different")
    void tellsNothingOfEqualOnes() {
        assertEquals(List.of(), compared(new GradedOutcome("ok", 6, 3)));
    }

    private static List<String> compared(GradedOutcome found) {
        return GradedOutcome.differences(Map.of("a", RIGHT), Map.of("a", found));
    }
}
