package rasterlab.engine.light.face;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.math.MathContext;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class RootSumTest {
    private static final MathContext DIGITS = new MathContext(100);

    /** Sums of such small numbers are 0 or at least 10⁻²⁰ in size. */
    private static final BigDecimal LEAST = new BigDecimal("1e-50");

    @Property
    void signIsThatOfAHundredDigits(
            @ForAll @IntRange(min = -9, max = 9) int a,
            @ForAll @IntRange(min = -9, max = 9) int b,
            @ForAll @IntRange(min = 1, max = 9) int p,
            @ForAll @IntRange(min = -9, max = 9) int c,
            @ForAll @IntRange(min = 1, max = 9) int q) {
        BigDecimal sum = big(a).add(root(b, p)).add(root(c, q));
        assertEquals(sum.abs().compareTo(LEAST) < 0 ? 0 : sum.signum(), signum(a, b, p, c, q));
    }

    @Test
    void equalRootsInOtherWordsCancel() {
        assertEquals(0, signum(0, 1, 8, -2, 2));
        assertEquals(0, signum(-6, 2, 4, 2, 1));
    }

    private static int signum(int a, int b, int p, int c, int q) {
        return RootSum.signum(big(a), big(b), big(p), big(c), big(q));
    }

    private static BigDecimal root(int times, int of) {
        return big(times).multiply(big(of).sqrt(DIGITS));
    }

    private static BigDecimal big(int value) {
        return BigDecimal.valueOf(value);
    }
}
