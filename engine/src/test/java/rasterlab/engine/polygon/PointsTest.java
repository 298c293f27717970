package rasterlab.engine.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class PointsTest {
    @Test
    void aMethodThatWritesIntoItsInputLeavesThePointsAsTheyAre() {
        Points points = Points.of(1, 2, 3, 4);
        points.xs()[0] = 9;
        points.ys()[1] = 9;
        assertEquals(Points.of(1, 2, 3, 4), points);
    }
}
