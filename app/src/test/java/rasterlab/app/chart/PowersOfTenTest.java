package rasterlab.app.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PowersOfTenTest {
    @ParameterizedTest(name = "an axis does not write {1} for {0}")
    @CsvSource({"1e4, 10⁴", "1e-12, 10⁻¹²", "99.9999999, 10²", "1, 1", "10, 10"})
    void isWrittenWithItsExponent(double value, String written) {
        assertEquals(written, PowersOfTen.nearest(value));
    }
}
