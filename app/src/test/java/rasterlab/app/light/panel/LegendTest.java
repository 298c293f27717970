package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LegendTest {
    private static final Legend LEGEND =
            new Legend(
                    Stream.of("flat", "Gouraud", "Phong", "dashed: perceived brightness")
                            .map(name -> new Legend.Entry(name, Color.BLACK, false))
                            .toList());

    @ParameterizedTest(name = "an entry is lost, cut off or overprinted in type of {0}")
    @ValueSource(ints = {12, 20, 28, 38})
    void everyEntryHasItsPlace(int size) {
        FontMetrics metrics =
                new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)
                        .createGraphics()
                        .getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, size));
        List<Rectangle> places = LEGEND.places(metrics, 60, 8, 600);
        assertEquals(4, places.size());
        for (int i = 0; i < 4; i++) {
            assertTrue(places.get(i).x >= 8 && places.get(i).getMaxX() <= 600, places.toString());
            for (int j = 0; j < i; j++)
                assertFalse(places.get(i).intersects(places.get(j)), places.toString());
        }
    }
}
