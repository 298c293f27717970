package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.tests.bench.language.BenchWords;

class SegmentCountsTest {
    @ParameterizedTest(name = "a method makes more segments than it may in boxes of {0} pixels")
    @ValueSource(ints = {20, 200, 1000})
    void segmentsAreFew(int box) {
        SegmentCounts counts = SegmentCounts.of(box);
        String said = "seed " + SegmentCounts.SEED + ": " + counts;
        assertTrue(counts.fewest() <= SegmentCounts.FEWEST * counts.least(), said);
        assertTrue(counts.adaptive() <= SegmentCounts.ADAPTIVE * counts.jdk(), said);
    }

    @ParameterizedTest(name = "the least possible, {1} a curve, is found to be another number")
    @CsvSource({"20, 4.0", "200, 13.1", "1000, 26.0"})
    void theLeastIsNearThatOfOtherCurves(int box, double expected) {
        assertEquals(
                expected,
                SegmentCounts.of(box).least() / (double) SegmentCounts.CURVES,
                0.1 * expected);
    }

    @Test
    @DisplayName("a line of the table lacks a number, or a method")
    void tableHasALineForEachMethodAndSize() {
        var printed = new ByteArrayOutputStream();
        SegmentCounts.print(
                BenchWords.ENGLISH, new PrintStream(printed, true, StandardCharsets.UTF_8));
        List<String> lines = printed.toString(StandardCharsets.UTF_8).lines().toList();
        assertEquals(8, lines.size(), lines.toString());
        for (String line : lines.subList(2, 8))
            assertTrue(
                    line.matches(
                            "Bézier curves of \\d+ px, \\w+ (\\| \\w+ \\d+\\.\\d ){2}"
                                    + "\\| \\d\\.\\d{3} \\| 1\\.\\d0 \\| yes"),
                    line);
    }
}
