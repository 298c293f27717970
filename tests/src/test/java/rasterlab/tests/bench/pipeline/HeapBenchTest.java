package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class HeapBenchTest {
    @Test
    void aMillionTrianglesFitIntoSixHundredMegabytes() {
        assertEquals("drawn", HeapBench.run().note());
    }
}
