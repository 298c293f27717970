package rasterlab.engine.sight;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DepthBitsTest {
    @ParameterizedTest(name = "near {0}, far {1}, {2} bits are one too few or too many")
    @CsvSource({"1, 1000, 16", "10, 100, 8", "0.1, 10000, 24"})
    void fewestBitsAreJustEnough(double near, double far, int bits) {
        double justEnough = DepthBits.step(bits, far, near, far) * 1.000001;
        double justNot = DepthBits.step(bits, far, near, far);
        assertEquals(bits, DepthBits.fewest(far, near, far, justEnough));
        assertEquals(bits + 1, DepthBits.fewest(far, near, far, justNot));
    }

    @Test
    void stepGrowsWithTheSquareOfTheDepth() {
        assertEquals(4 * DepthBits.step(16, 50, 1, 1000), DepthBits.step(16, 100, 1, 1000), 1e-12);
        assertEquals(999_000.0 / 65536, DepthBits.step(16, 1000, 1, 1000), 1e-9);
    }

    @Test
    void nothingApartIsRefused() {
        var refusal =
                assertThrows(IllegalArgumentException.class, () -> DepthBits.fewest(10, 1, 10, 0));
        assertTrue(refusal.getMessage().contains("got 0.0"), refusal.getMessage());
    }
}
