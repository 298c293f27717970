package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.CompiledCode;
import rasterlab.engine.raster.Work;

/** Compares the counted arithmetic with the compiled walks. */
class LineWorkTest {
    private static final LineTopic TOPIC = new LineTopic();

    private static Map<String, Long> counts(String method, Segment segment) {
        return TOPIC.operations(TOPIC.method(method).implementation(), segment);
    }

    /** Twelve pixels, four steps across. */
    @ParameterizedTest(name = "{0}: multiplications, additions or comparisons miscounted")
    @CsvSource({
        "bresenham, 20, 0, 0, 16",
        "midpoint, 23, 0, 0, 16",
        "dda, 19, 0, 2, 16",
        "naive, 27, 12, 2, 2",
        "naive-textbook, 26, 12, 1, 0",
        "bresenham-pascal-textbook, 19, 0, 0, 13"
    })
    void aSegmentCosts(
            String method, long additions, long multiplications, long divisions, long comparisons) {
        Map<String, Long> counts = counts(method, new Segment(0, 0, 11, 4));
        assertEquals(additions, counts.get("additions"));
        assertEquals(multiplications, counts.get("multiplications"));
        assertEquals(divisions, counts.get("divisions"));
        assertEquals(comparisons, counts.get("comparisons"));
    }

    @ParameterizedTest(name = "{0} multiplies or divides although it counts none")
    @ValueSource(
            strings = {
                "BresenhamLine",
                "MidpointLine",
                "DdaLine",
                "BresenhamTextbookLine",
                "BresenhamFirstTextbookLine",
                "BresenhamPascalTextbookLine"
            })
    void theCompiledStepHasNoMultiplication(String type) throws Exception {
        String step = compiledStep(type);
        assertEquals(0, occurrences(step, "[ilfd](mul|div|rem)"), step);
        var method =
                (SteppedLine)
                        Class.forName("rasterlab.engine.line." + type)
                                .getConstructor()
                                .newInstance();
        assertEquals(0, method.work().pixel().multiplications());
        assertEquals(0, method.work().across().multiplications());
    }

    /** Both branches of a step stand in the code: d grows in one or the other. */
    @Test
    void theCompiledStepOfBresenhamAddsToItsDecisionOnceInEachBranch() throws Exception {
        String step = compiledStep("BresenhamLine");
        assertEquals(2, occurrences(step, "putfield .*Field d:J"), step);
        assertEquals(new Work(1, 0, 0, 0, 1), new BresenhamLine().work().pixel());
        assertEquals(Work.NONE, new BresenhamLine().work().across());
    }

    private static String compiledStep(String type) {
        String all =
                CompiledCode.of(BresenhamLine.class, "rasterlab.engine.line." + type + "$Walk");
        int from = all.indexOf("public boolean advance()");
        assertTrue(from >= 0, all);
        return all.substring(from, all.indexOf("public int x()"));
    }

    private static long occurrences(String text, String pattern) {
        return Pattern.compile(pattern).matcher(text).results().count();
    }

    @Test
    void aDiagonalIsSevenTenthsAsBrightAsARow() {
        for (String name : List.of("bresenham", "wu")) {
            var method = TOPIC.method(name).implementation();
            assertEquals(1, brightness(method, 1000, 0), 1e-3, name);
            assertEquals(0.894, brightness(method, 1000, 500), 1e-3, name);
            assertEquals(0.707, brightness(method, 1000, -1000), 1e-3, name);
            assertEquals(0.707, brightness(method, -1000, 1000), 1e-3, name);
        }
    }

    private static double brightness(LineRasterizer method, int dx, int dy) {
        return LineBrightness.of(method, new Segment(7, 9, 7 + dx, 9 + dy)).perPixel();
    }

    @Test
    void aStudyCountsTheLightOfEachSlopeApart() {
        Map<String, Long> counts = counts("bresenham", new Segment(0, 0, 99, 99));
        assertEquals(100 * 255, counts.get("levels of light at 30–45°"));
        assertEquals(36_062, counts.get("levels of length at 30–45°"));
        Map<String, Long> flat = counts("bresenham", new Segment(0, 0, 99, 3));
        assertEquals(100 * 255, flat.get("levels of light at 0–15°"));
    }
}
