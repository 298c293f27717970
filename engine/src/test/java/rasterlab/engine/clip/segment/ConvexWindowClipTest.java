package rasterlab.engine.clip.segment;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.exact.ExactClip;

/** Cyrus–Beck in windows that are no upright rectangles. */
@Tag("slow")
class ConvexWindowClipTest {
    private static final CyrusBeck METHOD = new CyrusBeck();
    private static final double[] KITE = {0, -5, 8, 1, 4, 8, -3, 2};

    private static Optional<double[]> clip(double[] corners, double... ends) {
        var capture = new PartCapture(1);
        METHOD.clip(corners, ends[0], ends[1], ends[2], ends[3], capture);
        capture.next();
        return capture.captured().parts().get(0);
    }

    private static void assertRight(double[] corners, double... ends) {
        Optional<double[]> exact = ExactClip.convex(corners, ends);
        Optional<double[]> actual = clip(corners, ends);
        String where = Arrays.toString(ends) + " in " + Arrays.toString(corners);
        assertEquals(exact.isPresent(), actual.isPresent(), where);
        if (exact.isEmpty()) return;
        double extent = Arrays.stream(corners).map(Math::abs).max().orElseThrow();
        assertArrayEquals(exact.get(), actual.get(), SegmentClipTopic.RIGHT_UNITS * extent, where);
        for (int end = 0; end < 4; end += 2)
            if (exact.get()[end] == ends[end] && exact.get()[end + 1] == ends[end + 1])
                assertArrayEquals(
                        Arrays.copyOfRange(ends, end, end + 2),
                        Arrays.copyOfRange(actual.get(), end, end + 2),
                        where + " moves an end that is inside");
    }

    @Test
    void aSlantedEdgeCutsWhereItsNormalSays() {
        // the edge from (4, 0) to (0, 4) has n = (−4, −4): t = (16 − 4)/16 = 3/4 from (0, 1)
        double[] triangle = {0, 0, 4, 0, 0, 4};
        assertArrayEquals(
                new double[] {0, 1, 3, 1}, clip(triangle, 0, 1, 4, 1).orElseThrow(), 1e-15);
        var walk = METHOD.walk(triangle, 1, 1, 5, 1);
        assertTrue(walk.advance() && walk.advance());
        assertEquals("edge from (4.0, 0.0)", walk.at());
        assertEquals(0.5, walk.decision());
    }

    @Test
    void everySegmentOfASmallGridIsRightInEveryWindow() {
        double[][] windows = {
            KITE, {4, 8, 8, 1, 0, -5, -3, 2}, {0, 0, 4, 0, 0, 4}, {0, 0, 2, 1, 4, 2, 3, 4, 1, 3}
        };
        for (double[] window : windows)
            for (int i = 0; i < 12 * 12 * 12 * 12; i += 7)
                assertRight(
                        window, i % 12 - 4, i / 12 % 12 - 4, i / 144 % 12 - 4, i / 1728 % 12 - 4);
    }

    @Test
    void randomSegmentsNearAndFarAreRight() {
        var random = new Random(8);
        int unsure = 0;
        for (int i = 0; i < 5_000; i++) {
            double far = Math.pow(10, random.nextInt(4) == 0 ? 20 * random.nextDouble() - 5 : 1);
            double[] ends = random.doubles(4).map(r -> far * (3 * r - 1)).toArray();
            double[] window = ellipse(random);
            assertRight(window, ends);
            var walk = METHOD.walk(window, ends[0], ends[1], ends[2], ends[3]);
            while (walk.advance()) continue;
            if (walk.unsure()) unsure++;
        }
        assertTrue(unsure < 1_250, unsure + " handed over");
    }

    /** Segments from outside go past a corner, or to it, within a few steps between doubles. */
    @Test
    void segmentsThatTouchOrJustMissACornerAreRight() {
        var random = new Random(9);
        for (int i = 0; i < 5_000; i++) {
            double[] window = i % 2 == 0 ? KITE : ellipse(random);
            int corner = 2 * random.nextInt(window.length / 2);
            double dx = 8 * random.nextDouble() - 4;
            double dy = 8 * random.nextDouble() - 4;
            double on = random.nextInt(3) == 0 ? 0 : random.nextDouble();
            double x = random.nextBoolean() ? window[corner] : Math.nextUp(window[corner]);
            assertRight(
                    window,
                    x - dx,
                    window[corner + 1] - dy,
                    x + on * dx,
                    window[corner + 1] + on * dy);
        }
    }

    private static double[] ellipse(Random random) {
        int corners = 3 + random.nextInt(6);
        var window = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / corners;
            window[2 * i] = 5 + 10 * StrictMath.cos(angle);
            window[2 * i + 1] = 5 + 6 * StrictMath.sin(angle);
        }
        return window;
    }

    @Test
    void hugeAndTinyWindowsAndEndsAreRight() {
        for (double scale : new double[] {1e200, 1e-170, 0x1p-1060}) {
            double[] window = Arrays.stream(KITE).map(c -> c * scale).toArray();
            assertRight(window, -20 * scale, 3 * scale, 20 * scale, 4 * scale);
        }
        assertRight(KITE, -Double.MAX_VALUE, -1, Double.MAX_VALUE, 1);
    }

    @Test
    void aWindowThatIsNotConvexAndAnEndThatIsNowhereAreRefused() {
        double[] dented = {0, 0, 4, 0, 1, 1, 0, 4};
        var refusal = assertThrows(IllegalArgumentException.class, () -> clip(dented, 0, 0, 1, 1));
        assertTrue(refusal.getMessage().contains("(1.0, 1.0)"), refusal.getMessage());
        var nowhere =
                assertThrows(IllegalArgumentException.class, () -> clip(KITE, 0, 0, 1, Double.NaN));
        assertEquals("y of end 1 must be finite, got NaN", nowhere.getMessage());
    }
}
