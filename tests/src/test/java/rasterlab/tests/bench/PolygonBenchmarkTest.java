package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PolygonBenchmarkTest {
    /** One pixel in fifty: of a triangle of 30 pixels that is the peer's rounding at its edges. */
    private static final double TOLERATED = 0.02;

    @ParameterizedTest(name = "{0}: ours fills other pixels than the peer")
    @ValueSource(strings = {"3 in 10", "3 in 50", "3 in 200", "20 in 200", "200 in 400"})
    void bothFillTheSamePixels(String shape) {
        var benchmark = new PolygonBenchmark();
        benchmark.shape = shape;
        benchmark.prepare();
        assertEquals(0, benchmark.different(), TOLERATED);
    }
}
