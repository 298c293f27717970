package rasterlab.app.clip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Rectangle;
import java.util.List;
import org.junit.jupiter.api.Test;

class SignWordPlacesTest {
    private static final Rectangle VIEW = new Rectangle(0, 0, 400, 300);

    @Test
    void wordsStandToTheUpperRightWhereThatIsFree() {
        Rectangle place = new SignWordPlaces(VIEW, List.of()).take(200, 150, 50, 16);
        assertEquals(new Rectangle(212, 122, 50, 16), place);
    }

    @Test
    void wordsLieOverNoHandle() {
        var handle = new Rectangle(215, 110, 30, 30);
        Rectangle place = new SignWordPlaces(VIEW, List.of(handle)).take(200, 150, 50, 16);
        assertFalse(place.intersects(handle), place.toString());
    }

    @Test
    void wordsOfSignsInOnePlaceLieBesideEachOther() {
        var places = new SignWordPlaces(VIEW, List.of());
        Rectangle one = places.take(200, 150, 50, 16);
        Rectangle other = places.take(201, 151, 50, 16);
        assertFalse(one.intersects(other), one + " " + other);
    }

    @Test
    void wordsStayInTheView() {
        Rectangle place = new SignWordPlaces(VIEW, List.of()).take(390, 10, 50, 16);
        assertEquals(place, place.intersection(VIEW));
    }
}
