package rasterlab.engine.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.math.BigDecimal;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class OrientationTest {
    private static final long SEED = 1997;
    private static final int TRIALS = Boolean.getBoolean("rasterlab.full") ? 10_000_000 : 200_000;

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void signIsExact(double ax, double ay, double bx, double by, double cx, double cy) {
        assertExact(ax, ay, bx, by, cx, cy, "");
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("left and right are swapped", 0, 0, 1, 0, 0, 1),
                argumentSet("points on one line are rounded off it", 0.1, 0.1, 0.3, 0.3, 0.7, 0.7),
                argumentSet(
                        "difference loses its last bit", 0.5, 0.5, 12, 12, 24, Math.nextUp(24.0)),
                argumentSet("product overflows", 1e200, 1e200, 3e200, 2e200, -1e200, 3e200),
                argumentSet("products overflow to NaN", 1e200, 1e200, 3e200, 3e200, 7e200, 8e200),
                argumentSet("difference overflows", 1.7e308, 0, -1.7e308, 0, 1, -1.7e308),
                argumentSet("product vanishes", 1e-200, 1e-200, 3e-200, 2e-200, 0, 5e-200),
                argumentSet(
                        "smallest double counts as 0",
                        Double.MIN_VALUE,
                        0,
                        0,
                        Double.MIN_VALUE,
                        0,
                        0),
                argumentSet("largest beside smallest", 1.7e308, 1, 0, 0, -1.7e308, -1),
                argumentSet(
                        "error of a product is lost near the smallest double",
                        0x1.0000000000001p-520,
                        0x1.0000000000001p-520,
                        0x1.0000000000002p-520,
                        0x1.0000000000002p-520,
                        0,
                        0));
    }

    /** Corners anywhere, the point within 2 ulps of the line through them. */
    @Test
    void noSignIsWrongWithinTwoUlpsOfALine() {
        var random = new Random(SEED);
        for (int i = 0; i < TRIALS; i++) {
            double far = Math.scalb(1.0, random.nextInt(80) - 40);
            double ax = far * random.nextGaussian();
            double ay = random.nextGaussian();
            double bx = far * random.nextGaussian();
            double by = random.nextGaussian();
            double mu = 3 * random.nextDouble() - 1;
            double cx = near(ax + mu * (bx - ax), random);
            double cy = near(ay + mu * (by - ay), random);
            assertExact(ax, ay, bx, by, cx, cy, "seed " + SEED + ", trial " + i);
        }
    }

    private static double near(double value, Random random) {
        double moved = value;
        int steps = random.nextInt(5) - 2;
        for (int i = 0; i < Math.abs(steps); i++)
            moved = steps > 0 ? Math.nextUp(moved) : Math.nextDown(moved);
        return moved;
    }

    @Property(tries = 5_000, edgeCases = EdgeCasesMode.NONE)
    void anyDoublesHaveTheExactSignAndTurnBackWhenSwapped(
            @ForAll double ax,
            @ForAll double ay,
            @ForAll double bx,
            @ForAll double by,
            @ForAll double cx,
            @ForAll double cy) {
        assertExact(ax, ay, bx, by, cx, cy, "");
        assertEquals(
                Orientation.of(ax, ay, bx, by, cx, cy), -Orientation.of(bx, by, ax, ay, cx, cy));
    }

    /** Bits of every kind: subnormal, largest, equal and nearly equal numbers. */
    @Property(tries = 5_000)
    void anyBitPatternsHaveTheExactSign(@ForAll long seed) {
        var random = new Random(seed);
        var v = new double[6];
        for (int i = 0; i < 6; i++) {
            double bits = Double.longBitsToDouble(random.nextLong());
            boolean again = i > 0 && random.nextBoolean();
            v[i] = again ? near(v[random.nextInt(i)], random) : bits;
            if (!Double.isFinite(v[i])) v[i] = random.nextBoolean() ? Double.MAX_VALUE : 0;
        }
        assertExact(v[0], v[1], v[2], v[3], v[4], v[5], "seed " + seed);
    }

    @Test
    void numbersThatAreNoneAreRefused() {
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY})
            for (int place = 0; place < 6; place++) {
                var v = new double[] {0, 0, 4, 0, 0, 4};
                v[place] = bad;
                var refusal =
                        assertThrows(
                                IllegalArgumentException.class,
                                () -> Orientation.of(v[0], v[1], v[2], v[3], v[4], v[5]));
                assertEquals(
                        "coordinate " + place + " must be finite, got " + bad,
                        refusal.getMessage());
            }
    }

    private static void assertExact(
            double ax, double ay, double bx, double by, double cx, double cy, String where) {
        var x = new BigDecimal(cx);
        var y = new BigDecimal(cy);
        BigDecimal left = new BigDecimal(ax).subtract(x).multiply(new BigDecimal(by).subtract(y));
        BigDecimal right = new BigDecimal(ay).subtract(y).multiply(new BigDecimal(bx).subtract(x));
        int sign = Orientation.of(ax, ay, bx, by, cx, cy);
        if (sign != left.compareTo(right))
            assertEquals(
                    left.compareTo(right),
                    sign,
                    where + " (%s, %s) (%s, %s) (%s, %s)".formatted(ax, ay, bx, by, cx, cy));
    }
}
