package rasterlab.app.clip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class CodePlaceTest {
    private static final Rectangle REGION = new Rectangle(100, 50, 200, 120);

    /** A line from corner to corner, through the middle. */
    private static final Line2D ACROSS = new Line2D.Double(100, 50, 300, 170);

    private static Optional<Rectangle2D> place(Rectangle... labels) {
        return new CodePlace(REGION, List.of(labels), List.of()).of(50, 20);
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
    @DisplayName("a code lies over a segment, or so near that it touches a thick one")
    void givesWayToASegment() {
        Rectangle2D place =
                new CodePlace(REGION, List.of(), List.of(ACROSS)).of(50, 20).orElseThrow();
        for (double[] corner :
                new double[][] {
                    {place.getMinX(), place.getMinY()},
                    {place.getMaxX(), place.getMinY()},
                    {place.getMinX(), place.getMaxY()},
                    {place.getMaxX(), place.getMaxY()}
                })
            assertTrue(
                    ACROSS.ptSegDist(corner[0], corner[1]) > CodePlace.GAP / 2, place.toString());
        assertFalse(place.intersectsLine(ACROSS), place.toString());
        assertTrue(REGION.contains(place), place.toString());
    }

    @Test
    @DisplayName("a code touches the sides of its region")
    void keepsOffTheSides() {
        var narrow = new Rectangle(100, 50, 60, 30);
        assertTrue(new CodePlace(narrow, List.of(), List.of()).of(48, 18).isPresent());
        assertTrue(new CodePlace(narrow, List.of(), List.of()).of(49, 18).isEmpty());
        assertTrue(new CodePlace(narrow, List.of(), List.of()).of(48, 19).isEmpty());
    }

    @Test
    void isLeftOutWhereThereIsNoRoom() {
        assertEquals(Optional.empty(), place(REGION));
        Line2D other = new Line2D.Double(100, 170, 300, 50);
        var crossed = new CodePlace(REGION, List.of(), List.of(ACROSS, other));
        assertEquals(Optional.empty(), crossed.of(110, 60));
        assertTrue(crossed.of(50, 20).isPresent());
    }
}
