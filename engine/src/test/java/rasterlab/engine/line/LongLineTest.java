package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.Verdict.Kind;

/** Lines of which not all pixels are kept. */
class LongLineTest {
    private static final LineTopic TOPIC = new LineTopic();
    private static final LineRasterizer RIGHT = new MidpointLine();

    @ParameterizedTest
    @ValueSource(ints = {19_999, 20_000, 20_001, 31_234, 1_000_000, 1 << 24, 1_500_000_000})
    void aRightLineIsExactAtEveryLength(int n) {
        assertEquals(Kind.EXACT, verdict(RIGHT, new Segment(-5, 9, n - 5, n / 3)).kind());
        assertEquals(Kind.EXACT, verdict(RIGHT, new Segment(9, n / 7, -n / 9, -n + 9)).kind());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 999, 600_300, 1_000_000})
    void onePixelBesideTheLineIsSeenAtItsEndsAndWithin(int wrong) {
        var at = new int[1];
        LineRasterizer method =
                (x0, y0, x1, y1, out) -> {
                    at[0] = 0;
                    RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(x, at[0]++ == wrong ? y + 1 : y));
                };
        assertEquals(Kind.DEGRADED, verdict(method, new Segment(0, 0, 1_000_000, 3_000)).kind());
    }

    @Test
    void aLineThatEndsEarlyOrGoesOnForEverIsNotExact() {
        LineRasterizer early = (x0, y0, x1, y1, out) -> RIGHT.draw(x0, y0, x1 - 9, y1, out);
        LineRasterizer endless =
                (x0, y0, x1, y1, out) -> {
                    RIGHT.draw(x0, y0, x1, y1, out);
                    while (true) out.plot(x1, y1);
                };
        var segment = new Segment(0, 0, 1_000_000, 0);
        assertNotEquals(Kind.EXACT, verdict(early, segment).kind());
        assertEquals(Kind.ENDLESS, verdict(endless, segment).kind());
    }

    private static Verdict verdict(LineRasterizer method, Segment segment) {
        return HazardTrial.judge(
                TOPIC,
                Method.failing("made-up", method),
                new Hazard<>("made-up", segment, Map.of()),
                Duration.ofMinutes(2));
    }
}
