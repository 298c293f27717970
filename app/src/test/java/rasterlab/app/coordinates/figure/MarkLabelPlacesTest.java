package rasterlab.app.coordinates.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.List;
import org.junit.jupiter.api.Test;

class MarkLabelPlacesTest {
    private static final Rectangle VIEW = new Rectangle(0, 0, 200, 200);

    @Test
    void aloneALabelStandsToTheUpperRight() {
        Rectangle place = new MarkLabelPlaces(VIEW, List.of(), List.of()).take(100, 100, 20, 16);
        assertTrue(place.x > 100 && place.getMaxY() < 100, place.toString());
    }

    @Test
    void cornersNumberHidesNoneOfItsEdges() {
        var edges =
                List.<Line2D>of(
                        new Line2D.Double(100, 100, 190, 10),
                        new Line2D.Double(100, 100, 100, 190));
        Rectangle place = new MarkLabelPlaces(VIEW, edges, List.of()).take(100, 100, 20, 16);
        for (Line2D edge : edges) assertFalse(edge.intersects(place), place.toString());
    }

    @Test
    void labelsOfOnePlaceDoNotLieOnEachOther() {
        var places = new MarkLabelPlaces(VIEW, List.of(), List.of());
        Rectangle first = places.take(100, 100, 20, 16);
        assertFalse(places.take(100, 100, 20, 16).intersects(first));
    }

    @Test
    void labelOfAChosenVertexStandsOutsideItsRing() {
        var ring = new Rectangle(85, 85, 30, 30);
        Rectangle place =
                new MarkLabelPlaces(VIEW, List.of(), List.of(ring)).take(100, 100, 20, 16);
        assertFalse(place.intersects(ring), place.toString());
    }

    @Test
    void labelAtTheEdgeStaysInSight() {
        Rectangle place = new MarkLabelPlaces(VIEW, List.of(), List.of()).take(198, 2, 20, 16);
        assertEquals(place, place.intersection(VIEW));
    }
}
