package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NamedPicturesTest {
    private static final List<String> NAMES = List.of("Expected", "Actual", "Difference");
    private static final Font TYPE = new Font(Font.DIALOG, Font.PLAIN, 14);

    private static Optional<NamedPictures> placed(
            int across, int down, Font type, int width, int height) {
        var g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        return new NamedPictures.PicturesToPlace(
                        NAMES, new Dimension(across, down), type, g::getFontMetrics, 10)
                .in(new Dimension(width, height));
    }

    @ParameterizedTest(name = "{0}×{1} pixels are small beside empty room of {2}×{3}")
    @CsvSource({
        "10, 5, 280, 240, 13",
        "10, 5, 280, 900, 28",
        "10, 5, 900, 240, 29",
        "1, 9, 280, 240, 24",
        "4, 4, 300, 300, 28"
    })
    void pixelsAreAsLargeAsTheRoomAllows(int across, int down, int width, int height, int pixel) {
        NamedPictures placed = placed(across, down, TYPE, width, height).orElseThrow();
        Rectangle first = placed.places().get(0);
        assertEquals(0, first.width % across, "no whole number of units for each pixel");
        assertTrue(first.width / across >= pixel, "a pixel is " + first.width / across);
        assertEquals(first.width / across, first.height / down, "pixels are no squares");
    }

    @ParameterizedTest(name = "pictures or names of {0}×{1} pixels in {2}×{3} lie over each other")
    @CsvSource({"10, 5, 280, 240", "1, 9, 280, 240", "80, 40, 210, 190", "9, 9, 210, 400"})
    void nothingLiesOverAnotherOrOutside(int across, int down, int width, int height) {
        NamedPictures placed = placed(across, down, TYPE, width, height).orElseThrow();
        var g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        var metrics = g.getFontMetrics(placed.type());
        List<Rectangle> whole =
                IntStream.range(0, NAMES.size())
                        .mapToObj(
                                i -> {
                                    var named = new Rectangle(placed.places().get(i));
                                    int name = metrics.stringWidth(NAMES.get(i));
                                    named.width = Math.max(named.width, name);
                                    named.height += metrics.getHeight();
                                    return named;
                                })
                        .toList();
        var room = new Rectangle(width, height);
        for (Rectangle one : whole) {
            assertTrue(room.contains(one), one + " in " + room);
            for (Rectangle other : whole)
                assertFalse(one != other && one.intersects(other), one + " over " + other);
        }
    }

    @ParameterizedTest(name = "single pixels are not seen of {0}×{1} in room of {2}×{3}")
    @CsvSource({"80, 40, 280, 130", "80, 40, 210, 190", "80, 40, 600, 400", "40, 40, 280, 130"})
    void pixelsOfAPartAreSeen(int across, int down, int width, int height) {
        var g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        var wanted =
                new NamedPictures.PicturesToPlace(
                        NAMES, new Dimension(across, down), TYPE, g::getFontMetrics, 10);
        var room = new Dimension(width, height);
        Dimension part = wanted.part(3, room);
        Rectangle first = wanted.of(part).in(room).orElseThrow().places().get(0);
        assertTrue(first.width >= 3 * part.width, first + " for " + part);
        int taken = 3 * first.width * first.height;
        assertTrue(4 * taken >= width * height, "three of " + first + " leave the room empty");
    }

    @Test
    @DisplayName("pictures are cut that have room for all of their pixels")
    void wholePicturesAreShownWhereTheyHaveRoom() {
        var g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        var raster = new Dimension(10, 5);
        var wanted = new NamedPictures.PicturesToPlace(NAMES, raster, TYPE, g::getFontMetrics, 10);
        assertEquals(raster, wanted.part(3, new Dimension(280, 130)));
    }

    @Test
    @DisplayName("pictures stand in room that has none for their names")
    void namesWithoutRoomLeaveNoPlace() {
        assertTrue(placed(4, 4, TYPE, 20, 300).isEmpty());
    }
}
