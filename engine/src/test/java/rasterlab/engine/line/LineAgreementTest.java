package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.PixelRecording;

/**
 * The right methods against the exact line and against each other; 100,000 random segments instead
 * of 20,000 with {@code -Drasterlab.full=true}.
 */
@Tag("slow")
class LineAgreementTest {
    private static final LineTopic TOPIC = new LineTopic();
    private static final List<String> RIGHT =
            List.of("naive", "dda", "bresenham", "midpoint", "wu");
    private static final int SEGMENTS = Boolean.getBoolean("rasterlab.full") ? 100_000 : 20_000;
    private static final long SEED = 20_240_917;

    @Test
    void allAgreeOnEverySegmentOfA12By12Grid() {
        IntStream.range(0, 144 * 144)
                .mapToObj(i -> new Segment(i % 12, i / 12 % 12, i / 144 % 12, i / 1728))
                .forEach(segment -> assertAllExact(segment, "grid"));
    }

    @Test
    void allAgreeOnManyRandomSegments() {
        var random = new Random(SEED);
        for (int i = 0; i < SEGMENTS; i++)
            assertAllExact(randomSegment(random), "seed " + SEED + ", segment number " + i);
    }

    @ParameterizedTest(name = "longer by {0} than half, one in {0}")
    @ValueSource(ints = {0, 1, -1, 3_000_001, -5_592_405, 8_388_606, -8_388_607})
    void longestProvedLinesAreStillExact(int beyondHalf) {
        int n = DdaLine.MOST_STEPS - (beyondHalf & 1);
        int across = n / 2 + beyondHalf;
        assertWalksTogether(new Segment(-n / 2, 7, n - n / 2, 7 + across));
        assertWalksTogether(new Segment(across, n, 0, 0));
    }

    @Test
    void bresenhamIsRightFromEitherEndOfTheLongestLines() {
        int least = Integer.MIN_VALUE;
        int most = Integer.MAX_VALUE;
        for (int y : new int[] {least, least + 1, -1, 0, 1, 5, most - 1, most}) {
            Segment segment = new Segment(least, 0, most, y);
            assertPrefixExact(segment);
            assertPrefixExact(segment.reversed());
            assertPrefixExact(new Segment(y, most, y / 2, least));
        }
    }

    private static Segment randomSegment(Random random) {
        int bits = random.nextInt(1, 11);
        int far = 1 << random.nextInt(31);
        int x = random.nextInt(-far, far);
        int y = random.nextInt(-far, far);
        int reach = 1 << bits;
        return new Segment(
                x, y, x + random.nextInt(-reach, reach + 1), y + random.nextInt(-reach, reach + 1));
    }

    /** Every pixel of one method against the exact line, and of the others against that one. */
    private static void assertAllExact(Segment segment, String origin) {
        var exact = new ExactLine(segment);
        int size = (int) exact.size();
        PixelRecording first = null;
        for (String method : RIGHT) {
            PixelRecording drawn = record(method, segment, size + 2);
            String where = method + " " + segment + ", " + origin;
            assertEquals(size, drawn.size(), where);
            if (first == null) {
                for (int k = 0; k < size; k++) assertPixel(exact, k, drawn.x(k), drawn.y(k), where);
                first = drawn;
            } else {
                assertSame(first, drawn, where);
            }
        }
    }

    private static void assertSame(PixelRecording first, PixelRecording drawn, String where) {
        for (int k = 0; k < first.size(); k++)
            if (first.x(k) != drawn.x(k) || first.y(k) != drawn.y(k))
                assertEquals(first.x(k) + ", " + first.y(k), drawn.x(k) + ", " + drawn.y(k), where);
    }

    private static void assertPixel(ExactLine exact, long k, int x, int y, String where) {
        if (exact.x(k) != x || exact.y(k) != y)
            assertEquals(exact.x(k) + ", " + exact.y(k), x + ", " + y, where + ", pixel " + k);
    }

    private static void assertWalksTogether(Segment s) {
        var exact = new ExactLine(s);
        LineWalk naive = new NaiveLine().walk(s.x0(), s.y0(), s.x1(), s.y1());
        LineWalk dda = new DdaLine().walk(s.x0(), s.y0(), s.x1(), s.y1());
        LineWalk integer = new BresenhamLine().walk(s.x0(), s.y0(), s.x1(), s.y1());
        for (long k = 0; k <= s.steps(); k++) {
            assertTrue(naive.advance() && dda.advance() && integer.advance());
            if (naive.x() != dda.x()
                    || naive.y() != dda.y()
                    || dda.x() != integer.x()
                    || dda.y() != integer.y()
                    || k % 65_537 == 0)
                for (LineWalk walk : List.of(naive, dda, integer))
                    assertPixel(exact, k, walk.x(), walk.y(), walk.getClass() + " " + s);
        }
        assertFalse(naive.advance() || dda.advance() || integer.advance());
    }

    private static void assertPrefixExact(Segment s) {
        var exact = new ExactLine(s);
        LineWalk walk = new BresenhamLine().walk(s.x0(), s.y0(), s.x1(), s.y1());
        for (long k = 0; k < Math.min(1_000, exact.size()); k++) {
            assertTrue(walk.advance());
            assertPixel(exact, k, walk.x(), walk.y(), s.toString());
        }
    }

    private static PixelRecording record(String method, Segment segment, int limit) {
        return TOPIC.record(TOPIC.method(method).implementation(), segment, limit);
    }
}
