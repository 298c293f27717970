package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Method;

/** Checks properties of the walk of every method, faulty ones included. */
class LineWalkTest {
    private static final LineTopic TOPIC = new LineTopic();
    private static final long SEED = 31;

    @ParameterizedTest
    @MethodSource("names")
    void steppingShowsThePixelsThatDrawingSends(String name) {
        var method = (SteppedLine) TOPIC.method(name).implementation();
        var random = new Random(SEED);
        for (int i = 0; i < 3_000; i++) {
            var s = new Segment(near(random), near(random), near(random), near(random));
            PixelRecording drawn = TOPIC.record(method, s, 1_000);
            LineWalk walk = method.walk(s.x0(), s.y0(), s.x1(), s.y1());
            for (int p = 0; p < drawn.size(); p++) {
                assertTrue(walk.advance(), s + " ends at write " + p + ", seed " + SEED);
                assertEquals(drawn.x(p), walk.x(), s + " write " + p + ", seed " + SEED);
                assertEquals(drawn.y(p), walk.y(), s + " write " + p + ", seed " + SEED);
            }
            assertFalse(walk.advance(), s + " goes on, seed " + SEED);
            assertFalse(walk.advance(), s + " comes back to life, seed " + SEED);
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void saysWhatItsDecisionIs(String name) {
        var method = (SteppedLine) TOPIC.method(name).implementation();
        assertFalse(method.decisionFormula().isBlank());
        LineWalk walk = method.walk(0, 0, 10, 3);
        while (walk.advance()) assertTrue(Double.isFinite(walk.decision()), name);
    }

    @Test
    void bresenhamsDecisionKeepsToItsInvariant() {
        for (int b = 0; b <= 40; b++)
            for (int sign = -1; sign <= 1; sign += 2) {
                LineWalk walk = new BresenhamLine().walk(0, 0, 40, sign * b);
                for (int i = 0; walk.advance(); i++) {
                    int tie = sign * b < 0 ? 0 : 1;
                    long d = 2L * (i + 1) * b - (2L * Math.abs(walk.y()) + 1) * 40 - tie;
                    assertEquals(d, walk.decision(), "slope " + sign * b + "/40 at step " + i);
                    assertTrue(2 * b - 80 <= d && d < 2 * b, "d = " + d + " at step " + i);
                }
            }
    }

    @ParameterizedTest
    @ValueSource(strings = {"naive", "dda"})
    void refusesOneStepBeyondTheProof(String name) {
        LineRasterizer method = TOPIC.method(name).implementation();
        int most = 1 << 24;
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> method.draw(0, -1, 5, most, (x, y) -> {}));
        String message = refusal.getMessage();
        assertTrue(
                message.contains("from 0 to 16777216 steps") && message.contains("16777217"),
                message);
        method.draw(0, 0, 5, most, (x, y) -> {});
    }

    static Stream<String> names() {
        return TOPIC.methods().stream().map(Method::name);
    }

    private static int near(Random random) {
        return random.nextInt(-30, 31);
    }
}
