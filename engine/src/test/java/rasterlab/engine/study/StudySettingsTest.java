package rasterlab.engine.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.time.Duration;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class StudySettingsTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(long warmUp, long round, int rounds, long limit, String message) {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                new StudySettings(
                                        Duration.ofMillis(warmUp),
                                        Duration.ofMillis(round),
                                        rounds,
                                        Duration.ofMillis(limit)));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "negative warm-up is accepted",
                        -1,
                        5,
                        3,
                        9,
                        "warm-up must not be negative, got PT-0.001S"),
                argumentSet(
                        "empty round is accepted",
                        1,
                        0,
                        3,
                        9,
                        "round must be longer than 0, got PT0S"),
                argumentSet("no round is accepted", 1, 5, 0, 9, "rounds must be at least 1, got 0"),
                argumentSet(
                        "no time for an answer is accepted",
                        1,
                        5,
                        3,
                        -2,
                        "wall limit must be longer than 0, got PT-0.002S"));
    }

    @Test
    void studyMayBeginCold() {
        var cold = new StudySettings(Duration.ZERO, Duration.ofMillis(1), 1, Duration.ofMillis(1));
        assertEquals(Duration.ZERO, cold.warmUp());
    }
}
