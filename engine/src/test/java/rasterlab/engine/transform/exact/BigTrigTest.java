package rasterlab.engine.transform.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BigTrigTest {
    private static final BigDecimal TINY = new BigDecimal("1e-55");

    @Test
    void sineOf30DegreesIsAHalfAndCosineOf45TheRootOfAHalf() {
        assertClose("0.5", BigTrig.ofDegrees(30).sin());
        assertClose(
                new BigDecimal("0.5").sqrt(new MathContext(60)).toString(),
                BigTrig.ofDegrees(45).cos());
        assertClose("-0.5", BigTrig.ofDegrees(120).cos());
    }

    /** cos 20° · cos 40° · cos 80° = 1/8 holds only if many digits of π do. */
    @Test
    void morriesLawHoldsTo55Digits() {
        BigDecimal product =
                BigTrig.ofDegrees(20)
                        .cos()
                        .multiply(BigTrig.ofDegrees(40).cos())
                        .multiply(BigTrig.ofDegrees(80).cos());
        assertClose("0.125", product);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-9, 17.3, 90, 179.999, 180, 200, 270.5, -33, -300, 1e9 + 7.25})
    void squaresAddUpToOneAndQuadrantsAreThoseOfMath(double degrees) {
        BigTrig angle = BigTrig.ofDegrees(degrees);
        assertClose("1", angle.sin().multiply(angle.sin()).add(angle.cos().multiply(angle.cos())));
        double radians = Math.toRadians(Math.IEEEremainder(degrees, 360));
        assertEquals(Math.sin(radians), angle.sin().doubleValue(), 1e-15);
        assertEquals(Math.cos(radians), angle.cos().doubleValue(), 1e-15);
    }

    private static void assertClose(String expected, BigDecimal actual) {
        assertTrue(
                new BigDecimal(expected).subtract(actual).abs().compareTo(TINY) < 0,
                expected + " and " + actual);
    }
}
