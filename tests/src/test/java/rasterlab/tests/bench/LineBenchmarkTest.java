package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Checks what the table calls "pixels identical". */
@Tag("slow")
class LineBenchmarkTest {
    @ParameterizedTest(name = "{0} px: ours lights other pixels than the peer")
    @ValueSource(ints = {16, 128, 1000})
    void segmentsInsideLightTheSamePixels(int pixels) {
        var benchmark = new LineBenchmark();
        benchmark.pixels = pixels;
        benchmark.prepare();
        assertEquals(0, benchmark.different());
    }

    @ParameterizedTest(name = "{0} px: ours lights other pixels than the peer")
    @ValueSource(ints = {64, 4000})
    void clippedSegmentsLightTheSamePixels(int pixels) {
        assertEquals(0, clipped(pixels).different());
    }

    @Test
    void noClippedSegmentLiesInside() {
        assertEquals(0, clipped(64).inside());
        assertEquals(0, clipped(4000).inside());
    }

    private static ClippedLineBenchmark clipped(int pixels) {
        var benchmark = new ClippedLineBenchmark();
        benchmark.pixels = pixels;
        benchmark.prepare();
        return benchmark;
    }
}
