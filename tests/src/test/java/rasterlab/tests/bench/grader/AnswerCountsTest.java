package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class AnswerCountsTest {
    private final AnswerCounts counts = new AnswerCounts("nothing");

    @Test
    @DisplayName("answers of one status that say different things are counted together")
    void tellsProblemsAndWhenToComeAgain() {
        String full = "{\"type\":\"urn:rasterlab:problem:no-room\",\"status\":503}";
        String away = "{\"type\":\"urn:rasterlab:problem:storage\",\"status\":503}";
        counts.add(503, full, Optional.of("60"));
        counts.add(202, "{\"id\":\"a\"}", Optional.empty());
        counts.add(503, away, Optional.empty());
        counts.add(503, full, Optional.of("60"));
        counts.add(503, full, Optional.empty());
        counts.addSilence();
        assertEquals(
                "2 × 503 no-room, Retry-After 60; 1 × 202; 1 × 503 storage; 1 × 503 no-room;"
                        + " 1 × nothing",
                counts.text());
        assertEquals(6, counts.total());
    }

    @Test
    @DisplayName("an error of the server passes for being told to come again")
    void tellsFailuresThatDoNotAskToComeAgain() {
        counts.add(202, "", Optional.empty());
        counts.add(429, "", Optional.empty());
        counts.add(503, "", Optional.of("5"));
        counts.addSilence();
        assertEquals("", counts.unexcusedText());
        counts.add(503, "", Optional.empty());
        counts.add(500, "", Optional.of("5"));
        assertEquals("1 × 503; 1 × 500, Retry-After 5", counts.unexcusedText());
    }
}
