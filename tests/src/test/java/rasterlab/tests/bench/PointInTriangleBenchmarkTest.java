package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;

import org.junit.jupiter.api.Test;

class PointInTriangleBenchmarkTest {
    @Test
    void oursAndThePeerJudgeEveryPointAlike() {
        assertDoesNotThrow(() -> new PointInTriangleBenchmark().prepare());
    }
}
