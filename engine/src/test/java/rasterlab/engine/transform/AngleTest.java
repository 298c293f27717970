package rasterlab.engine.transform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.transform.exact.BigTrig;

class AngleTest {
    @ParameterizedTest(name = "{0}° leaves dust beside its 0 and 1")
    @CsvSource({"0,0,1", "90,1,0", "180,0,-1", "270,-1,0", "-90,-1,0", "450,1,0", "3.6e17,0,1"})
    void quartersAreExact(double degrees, double sin, double cos) {
        Angle angle = Angle.ofDegrees(degrees);
        assertEquals(sin, angle.sin() + 0.0);
        assertEquals(cos, angle.cos() + 0.0);
    }

    @Test
    @DisplayName("an angle is reduced with rounding")
    void isWithinTwoUlpOfTheExactValue() {
        long seed = 1706;
        var random = new Random(seed);
        for (int i = 0; i < 2_000; i++) {
            double degrees = Math.scalb(random.nextDouble(-1, 1), random.nextInt(-20, 60));
            Angle angle = Angle.ofDegrees(degrees);
            BigTrig exact = BigTrig.ofDegrees(degrees);
            String where = degrees + ", seed " + seed;
            assertUlps(exact.sin().doubleValue(), angle.sin(), where);
            assertUlps(exact.cos().doubleValue(), angle.cos(), where);
        }
    }

    @ParameterizedTest(name = "{0} degrees become NaN")
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void refuses(double degrees) {
        var refusal = assertThrows(IllegalArgumentException.class, () -> Angle.ofDegrees(degrees));
        assertEquals(
                "the angle must be a finite number of degrees, got " + degrees,
                refusal.getMessage());
    }

    private static void assertUlps(double exact, double actual, String where) {
        assertEquals(exact, actual, 2.5 * Math.ulp(exact), where);
    }
}
