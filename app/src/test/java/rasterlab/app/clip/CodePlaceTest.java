package rasterlab.app.clip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class CodePlaceTest {
    private static final Rectangle REGION = new Rectangle(100, 50, 200, 120);

    private static Optional<Rectangle2D> place(Rectangle... labels) {
        return CodePlace.of(REGION, 50, 20, List.of(labels));
    }

    @Test
    void standsInTheMiddleWhereThereIsNoLabel() {
        assertEquals(new Rectangle2D.Double(175, 100, 50, 20), place().orElseThrow());
        assertEquals(place(), place(new Rectangle(100, 50, 60, 20)));
    }

    @Test
    void givesWayToALabelWithinTheRegion() {
        var label = new Rectangle(180, 105, 60, 20);
        Rectangle2D place = place(label).orElseThrow();
        assertFalse(place.intersects(label), place.toString());
        assertTrue(REGION.contains(place), place.toString());
    }

    @Test
    void isLeftOutWhereThereIsNoRoom() {
        assertEquals(Optional.empty(), place(REGION));
        assertEquals(Optional.empty(), CodePlace.of(REGION, 201, 20, List.of()));
        assertEquals(Optional.empty(), CodePlace.of(REGION, 50, 121, List.of()));
    }
}
