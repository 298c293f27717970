package rasterlab.engine.visibility.depth;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.DepthFormat;
import rasterlab.contract.DepthRange;
import rasterlab.engine.study.Method;

/** Single depths: what is stored, what it stands for and what is told apart. */
class DepthFormatTest {
    private static final DepthBufferTopic TOPIC = new DepthBufferTopic();
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    static Stream<Method<DepthFormat>> methods() {
        return TOPIC.methods().stream();
    }

    private static DepthCoding coding(Method<DepthFormat> method) {
        return (DepthCoding) method.implementation();
    }

    private static DepthCoding.RangeCodes codes(String method, DepthRange range) {
        return coding(TOPIC.method(method)).over(range);
    }

    @Property(tries = 500)
    void wholeNumbersAreTheRoundedOnes(@ForAll long seed) {
        var random = new Random(seed);
        DepthRange range = range(random);
        double z = depth(random, range);
        for (int bits : new int[] {16, 24, 32})
            assertRounded(
                    codes("z" + bits, range),
                    z,
                    ExactCode.number(ExactCode.window(range, z), bits),
                    seed);
        assertRounded(
                codes("linear-16", range),
                z,
                ExactCode.number(ExactCode.linear(range, z), 16),
                seed);
    }

    /** 1/z in doubles may be off by 2⁻⁵² of 1/near: 10⁻⁵ steps of 32 bits are ample. */
    private static void assertRounded(
            DepthCoding.RangeCodes codes, double z, BigDecimal right, long seed) {
        double stored = codes.stored(codes.code(1 / z));
        double off = new BigDecimal(stored).subtract(right).doubleValue();
        assertTrue(Math.abs(off) <= 0.5 + 1e-5, () -> z + " off by " + off + ", seed " + seed);
    }

    @Property(tries = 500)
    void floatsAreTheNearestOnes(@ForAll long seed) {
        var random = new Random(seed);
        DepthRange range = range(random);
        double z = depth(random, range);
        BigDecimal window = ExactCode.window(range, z);
        assertNearest(codes("zfloat", range), z, window, seed);
        assertNearest(codes("reversed-z", range), z, BigDecimal.ONE.subtract(window), seed);
    }

    private static void assertNearest(
            DepthCoding.RangeCodes codes, double z, BigDecimal right, long seed) {
        float stored = (float) codes.stored(codes.code(1 / z));
        double off = new BigDecimal(stored).subtract(right).abs().doubleValue();
        double allowed = Math.ulp(stored) / 2 * (1 + 1e-6) + 1e-15;
        assertTrue(off <= allowed, () -> z + " off by " + off + ", seed " + seed);
    }

    @Property(tries = 300)
    void whatIsToldApartIsWhereTheNextNumberBegins(@ForAll long seed) {
        var random = new Random(seed);
        DepthRange range = range(random);
        double z = depth(random, range);
        for (int bits : new int[] {16, 24, 32}) {
            DepthCell cell = DepthCell.of(codes("z" + bits, range), range, z);
            BigDecimal begins = ExactCode.nextBegins(ExactCode.window(range, z), bits);
            if (begins.compareTo(BigDecimal.ONE) > 0) {
                assertEquals(Double.NaN, cell.behind(range, z), "seed " + seed);
                continue;
            }
            double right = ExactCode.depth(range, begins).subtract(new BigDecimal(z)).doubleValue();
            double step = z * z / range.near() / Math.pow(2, bits);
            double found = cell.behind(range, z);
            if (right < step * 1e-4) continue; // z stands on the border, where rounding decides
            assertEquals(
                    right,
                    Double.isNaN(found) ? range.far() - z : found,
                    1e-4 * Math.max(right, step) + 2 * Math.ulp(z),
                    "z" + bits + ", seed " + seed);
        }
    }

    private static DepthRange range(Random random) {
        double near = Math.pow(10, random.nextDouble(-3, 3));
        return new DepthRange(near, near * Math.pow(10, random.nextDouble(0.1, 5)));
    }

    private static double depth(Random random, DepthRange range) {
        double z = range.near() * Math.pow(range.far() / range.near(), random.nextDouble());
        return Math.max(range.near(), Math.min(range.far(), z));
    }

    @ParameterizedTest(name = "{0}: nearer depths get greater codes somewhere")
    @MethodSource("methods")
    void codesGrowWithDepth(Method<DepthFormat> method) {
        for (double far : new double[] {1.1, 10, 1e3, 1e9}) {
            DepthCoding.RangeCodes codes = coding(method).over(new DepthRange(1, far));
            int last = codes.code(1);
            for (int i = 0; i <= 4000; i++) {
                double z = Math.min(far, Math.pow(far, i / 4000.0));
                int code = codes.code(1 / z);
                assertTrue(code >= last, method.name() + " falls at " + z + " of " + far);
                last = code;
            }
            assertTrue(last > codes.code(1), method.name() + " up to " + far);
        }
    }

    @ParameterizedTest(name = "{0}: a plane''s own depth is lost, or one beyond it wraps round")
    @MethodSource("methods")
    void planesAreTheFirstAndTheLastCode(Method<DepthFormat> method) {
        var range = new DepthRange(0.3, 7000);
        DepthCoding.RangeCodes codes = coding(method).over(range);
        int first = codes.code(1 / range.near());
        int last = codes.code(1 / range.far());
        assertEquals(0.3, codes.depth(first), 1e-12);
        assertEquals(7000, codes.depth(last), 1e-3);
        assertEquals(first, codes.code(1e9), method.name());
        assertEquals(last, codes.code(0), method.name());
        assertEquals(last, codes.code(-1e-9), method.name());
    }

    @Test
    void whatIsStoredIsWhatTheFieldStores() {
        var range = new DepthRange(1, 1000);
        assertEquals(65535, codes("z16", range).stored(codes("z16", range).code(0.001)));
        assertEquals(4294967295.0, codes("z32", range).stored(codes("z32", range).code(0.001)));
        assertEquals(0, codes("z32", range).stored(codes("z32", range).code(1)));
        assertEquals(1, codes("zfloat", range).stored(codes("zfloat", range).code(0.001)));
        assertEquals(1, codes("reversed-z", range).stored(codes("reversed-z", range).code(1)));
        assertEquals(0, codes("reversed-z", range).stored(codes("reversed-z", range).code(0.001)));
    }

    @Test
    void withoutAFarPlaneReversedDepthTellsUnitsApartAMillionAway() {
        var range = new DepthRange(1, INFINITE);
        DepthCoding.RangeCodes reversed = codes("reversed-z", range);
        double behind = DepthCell.of(reversed, range, 1e6).behind(range, 1e6);
        assertTrue(behind > 0 && behind < 0.13, "reversed-z: " + behind);
        double whole = DepthCell.of(codes("z24", range), range, 1e6).behind(range, 1e6);
        assertTrue(whole > 1e4 && whole < 7e4, "z24: " + whole);
        assertEquals(Double.NaN, DepthCell.of(codes("z16", range), range, 1e6).behind(range, 1e6));
        var refusal = assertThrows(IllegalArgumentException.class, () -> codes("linear-16", range));
        assertEquals(
                "far must be finite for equal steps of depth, got Infinity", refusal.getMessage());
    }

    @Test
    void nothingIsToldApartBehindTheFarPlane() {
        var range = new DepthRange(1, 1000);
        assertEquals(
                Double.NaN, DepthCell.of(codes("z24", range), range, 1000).behind(range, 1000));
    }

    @ParameterizedTest(name = "{0}: a row that begins later has other codes")
    @MethodSource("methods")
    void rowsBeginAtTheirFirstPixel(Method<DepthFormat> method) {
        DepthCoding.RangeCodes codes = coding(method).over(new DepthRange(1, 1000));
        double base = 0.5;
        double perPixel = -0.001;
        var row = new int[3];
        codes.row(base, perPixel, 40, 42, row);
        int[] single = {codes.code(base + 40 * perPixel), codes.code(base + 41 * perPixel), 0};
        assertEquals(single[0], row[0], method.name());
        assertTrue(Math.abs((long) single[1] - row[1]) <= 1, method.name());
        assertEquals(0, row[2], "beyond the row");
        codes.row(base, perPixel, 7, 7, row);
        assertEquals(single[0], row[0], "an empty row writes nothing");
    }

    @Test
    void refusesPlanesThatAreNone() {
        refused("near must be from 1E-100 to 1E100, got 0.0", () -> new DepthRange(0, 1));
        refused("near must be from 1E-100 to 1E100, got NaN", () -> new DepthRange(0 / 0.0, 1));
        refused(
                "far must be at least 1.000001·near and at most 1E100, or infinite, got 5.0 with near 5.0",
                () -> new DepthRange(5, 5));
        refused(
                "far must be at least 1.000001·near and at most 1E100, or infinite, got 4.0 with near 5.0",
                () -> new DepthRange(5, 4));
        var range = new DepthRange(1, 10);
        refused(
                "depths[1] must be finite and from near to far, 1.0 to 10.0, got 10.5",
                () -> DepthRows.pixel(range, 1, 10.5));
        refused("number of surfaces must be from 1 to 1000, got 0", () -> DepthRows.pixel(range));
        refused(
                "to must have as many depths as depths, 2, got 1",
                () -> new DepthRows(range, new double[] {1, 2}, new double[] {1}, 3));
        refused(
                "pixels must be from 1 to 8192, got 8193",
                () -> new DepthRows(range, new double[] {1}, new double[] {1}, 8193));
    }

    private static void refused(String message, org.junit.jupiter.api.function.Executable call) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, call).getMessage());
    }

    @Test
    void depthTestKeepsTheFirstOfEqualCodes() {
        var codes = new StoredDepths(2, new int[] {5, 5, 5, 4, 4, 4}, new double[6]);
        assertEquals(List.of(2, 1), List.of(codes.front(0), codes.front(1)));
        var rows = DepthRows.pixel(new DepthRange(1, 1000), 900, 901);
        StoredDepths stored = TOPIC.record(TOPIC.method("z16").implementation(), rows, 99);
        assertArrayEquals(new int[] {stored.codes()[1], stored.codes()[1]}, stored.codes());
    }
}
