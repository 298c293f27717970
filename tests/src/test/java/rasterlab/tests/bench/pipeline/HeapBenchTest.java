package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import rasterlab.tests.bench.BenchWords;

class HeapBenchTest {
    @Test
    void aMillionTrianglesFitIntoSixHundredMegabytes() {
        assertEquals("drawn", HeapBench.run().note().apply(BenchWords.ENGLISH));
    }
}
