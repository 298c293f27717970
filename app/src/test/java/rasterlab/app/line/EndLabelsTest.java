package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.util.List;
import org.junit.jupiter.api.Test;

class EndLabelsTest {
    private static final Rectangle STAGE = new Rectangle(0, 0, 400, 300);
    private static final Rectangle RING = new Rectangle(190, 140, 30, 30);

    private static Rectangle place(Rectangle ring, Rectangle... seen) {
        return EndLabels.place(80, 20, ring, true, STAGE, List.of(seen));
    }

    @Test
    void standsBeyondTheEnd() {
        assertEquals(new Rectangle(165, 114, 80, 20), place(RING));
    }

    @Test
    void leavesAMarkedPixelInSight() {
        var marked = new Rectangle(200, 100, 30, 30);
        assertEquals(new Rectangle(165, 176, 80, 20), place(RING, marked));
        var other = new Rectangle(170, 170, 30, 30);
        Rectangle beside = place(RING, marked, other);
        assertTrue(!beside.intersects(marked) && !beside.intersects(other), beside.toString());
    }

    @Test
    void staysOnTheStage() {
        for (int x : new int[] {-500, 0, 390, 900})
            for (int y : new int[] {-500, 0, 290, 900}) {
                Rectangle place = place(new Rectangle(x, y, 30, 30), RING);
                assertTrue(STAGE.contains(place), place.toString());
            }
    }
}
