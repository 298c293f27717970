package rasterlab.engine.range;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.texture.TexelShare;

class BoundsTest {
    @ParameterizedTest(name = "{argumentSetName} is let in")
    @MethodSource("outside")
    void refusesWithNameRangeAndValue(Executable check, String message) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, check).getMessage());
    }

    static Stream<Arguments> outside() {
        return Stream.of(
                refused(
                        "a whole number below",
                        () -> Bounds.require("n", -1, 0, 9),
                        "0 to 9, got -1"),
                refused(
                        "a whole number above",
                        () -> Bounds.require("n", 10, 0, 9),
                        "0 to 9, got 10"),
                refused(
                        "a number below",
                        () -> Bounds.require("n", -0.5, 0, 1),
                        "0.0 to 1.0, got -0.5"),
                refused(
                        "a number above",
                        () -> Bounds.require("n", 1.5, 0, 1),
                        "0.0 to 1.0, got 1.5"),
                refused(
                        "no number",
                        () -> Bounds.require("n", Double.NaN, 0, 1),
                        "0.0 to 1.0, got NaN"),
                argumentSet(
                        "a whole number below the least",
                        (Executable) () -> Bounds.requireAtLeast("n", 0, 1),
                        "n must be at least 1, got 0"),
                argumentSet(
                        "no number, which is below nothing",
                        (Executable) () -> Bounds.requireAtLeast("n", Double.NaN, 0),
                        "n must be at least 0.0, got NaN"),
                argumentSet(
                        "0 as a sign",
                        (Executable) () -> Bounds.requireSign("turn", 0),
                        "turn must be 1 or -1, got 0"),
                argumentSet(
                        "a share of more than all",
                        (Executable) () -> new TexelShare(0, 0, 0, 1.25, 0),
                        "share must be from 0.0 to 1.0, got 1.25"));
    }

    private static Arguments refused(String mistake, Executable check, String range) {
        return argumentSet(mistake, check, "n must be from " + range);
    }

    @Test
    @DisplayName("an end of the range is refused")
    void takesBothEnds() {
        Bounds.require("n", 0, 0, 9);
        Bounds.require("n", 9, 0, 9);
        Bounds.require("n", 0.0, 0, 1);
        Bounds.require("n", 1.0, 0, 1);
        Bounds.requireAtLeast("n", 1, 1);
        Bounds.requireSign("n", 1);
        Bounds.requireSign("n", -1);
        assertEquals(1, new TexelShare(0, 0, 0, 1, 0).share());
    }
}
