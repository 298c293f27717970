package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.Random;
import java.util.function.IntBinaryOperator;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.Raster;

class ImagePicturesTest {
    private static final int GREEN = 0xFF208040;

    @Test
    void aSmallImageIsEnlargedByAWholeFactor() {
        Raster image = image(20, 10, (x, y) -> (x + y) % 2 == 0 ? GREEN : 0xFFFFFFFF);
        Seen seen = new Seen(ImagePictures.of(image, image, 0));
        seen.assertComplete("a small image");
        assertEquals(500, seen.expected().getWidth());
        assertEquals(250, seen.expected().getHeight());
        for (int x = 0; x < 500; x++)
            assertEquals(image.argb(x / 25, 3), seen.expected().getRGB(x, 3 * 25 + 12));
        assertEquals("an image, width: 20, height: 10; scale 25:1", seen.expectedText("en"));
        assertEquals("изображение, ширина: 20, высота: 10; масштаб 25:1", seen.actualText("ru"));
    }

    @Test
    void aWrongPixelIsRedAndCrossedAndNoOther() {
        Raster expected = image(16, 16, (x, y) -> GREEN);
        Raster actual = image(16, 16, (x, y) -> x == 5 && y == 9 ? 0xFFFF8040 : GREEN);
        Seen seen = new Seen(ImagePictures.of(expected, actual, 0));
        var cell = new Rectangle2D.Double(5 * 32, 9 * 32, 32, 32);
        Color red = ImagePictures.strength(0xFF - 0x20);
        assertTrue(Seen.count(seen.difference(), red, cell) > 400);
        assertTrue(Seen.count(seen.difference(), PixelMark.COLOUR, cell) > 30);
        assertEquals(Seen.count(seen.difference(), red, cell), Seen.count(seen.difference(), red));
        int grays = 0;
        for (int y = 0; y < 512; y++)
            for (int x = 0; x < 512; x++) {
                var color = new Color(seen.difference().getRGB(x, y));
                if (color.getRed() == color.getGreen() && color.getRed() == color.getBlue())
                    grays++;
            }
        assertTrue(grays >= 512 * 512 - 32 * 32, "the rest is gray: " + grays);
    }

    @Test
    void aLargerDifferenceIsAStrongerRed() {
        for (int levels = 1; levels < 255; levels++)
            assertTrue(
                    ImagePictures.strength(levels).getGreen()
                            >= ImagePictures.strength(levels + 1).getGreen());
        int weak = ImagePictures.strength(1).getGreen();
        assertTrue(weak > ImagePictures.strength(255).getGreen() + 100, "weak: " + weak);
        assertTrue(weak < 170, "1 level is seen beside white");
    }

    @Test
    void aDifferenceWithinTheToleranceIsNone() {
        Raster expected = image(4, 4, (x, y) -> GREEN);
        Raster actual = image(4, 4, (x, y) -> GREEN + 2);
        assertEquals(
                "there is no difference",
                new Seen(ImagePictures.of(expected, actual, 2)).differenceText("en"));
        assertEquals(
                "pixels that differ: 16 of 16; the first is (0, 0), a channel differs by 2 of 255",
                new Seen(ImagePictures.of(expected, actual, 1)).differenceText("en"));
        assertEquals(
                "отличается пикселей: 16 из 16;"
                        + " первый из них (0; 0), канал отличается на 2 из 255",
                new Seen(ImagePictures.of(expected, actual, 1)).differenceText("ru"));
    }

    @Test
    void aLargeImageIsCutAroundItsFirstWrongPixel() {
        Raster expected = image(1500, 900, (x, y) -> GREEN);
        Raster actual = image(1500, 900, (x, y) -> x == 1200 && y == 850 ? 0 : GREEN);
        Seen seen = new Seen(ImagePictures.of(expected, actual, 0));
        seen.assertComplete("a large image");
        assertEquals(512, seen.difference().getWidth());
        assertTrue(
                seen.actualText("en")
                        .contains("columns 944..1455 of 0..1499, rows 388..899 of 0..899"),
                seen.actualText("en"));
        var place = new Rectangle2D.Double(1200 - 944 - 1, 850 - 388 - 1, 3, 3);
        Color red = ImagePictures.strength(255);
        assertEquals(9, Seen.count(seen.difference(), red, place), "a spot that can be seen");
        assertTrue(Seen.count(seen.difference(), PixelMark.COLOUR) > 50, "a ring around it");
        assertTrue(
                seen.actualText("ru")
                        .endsWith(
                                "пиксель (1200; 850): красный 0, зелёный 0, синий 0,"
                                        + " непрозрачность 0, каждое от 0 до 255"));
    }

    @Test
    void transparencyShowsAChequeredGround() {
        Raster empty = image(2, 2, (x, y) -> 0x00FFFFFF);
        Raster white = image(2, 2, (x, y) -> 0xFFFFFFFF);
        Seen seen = new Seen(ImagePictures.of(empty, white, 0));
        assertNotEquals(seen.expected().getRGB(4, 4), seen.expected().getRGB(12, 4));
        assertEquals(seen.expected().getRGB(4, 4), seen.expected().getRGB(12, 12));
        assertEquals(seen.actual().getRGB(4, 4), seen.actual().getRGB(12, 4));
        Raster hidden = image(2, 2, (x, y) -> 0x00123456);
        assertEquals(
                "there is no difference",
                new Seen(ImagePictures.of(empty, hidden, 0)).differenceText("en"),
                "nobody sees the color of what is transparent");
    }

    @Test
    void aStripIsShownSoLargeThatItCanBeSeen() {
        Raster expected = image(2000, 1, (x, y) -> GREEN);
        Raster actual = image(2000, 1, (x, y) -> x == 1000 ? 0xFFFFFFFF : GREEN);
        Seen seen = new Seen(ImagePictures.of(expected, actual, 0));
        assertEquals(16, seen.difference().getHeight());
        assertTrue(Seen.count(seen.difference(), PixelMark.COLOUR) > 5);
    }

    @Test
    void anyImagesCanBeDrawn() {
        long seed = new Random().nextLong();
        anyImagesAreComplete(seed);
    }

    @Test
    void noisyImagesAreSmallAsFiles() {
        anyImagesAreComplete(473593361175330684L);
    }

    private static void anyImagesAreComplete(long seed) {
        var random = new Random(seed);
        for (int i = 0; i < 12; i++) {
            int width = 1 + random.nextInt(i == 0 ? 900 : 200);
            int height = 1 + random.nextInt(i == 0 ? 900 : 200);
            Raster expected = image(width, height, (x, y) -> random.nextInt());
            Raster actual =
                    image(
                            width,
                            height,
                            (x, y) ->
                                    random.nextInt(9) == 0
                                            ? random.nextInt()
                                            : expected.argb(x, y));
            new Seen(ImagePictures.of(expected, actual, random.nextInt(300)))
                    .assertComplete("seed " + seed + ", image " + i);
        }
    }

    @Test
    void imagesOfTwoSizesAreRefused() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> ImagePictures.of(new Raster(3, 2), new Raster(2, 3), 0));
        assertEquals(
                "images of one size are compared, got 3×2 expected and 2×3 actual",
                refused.getMessage());
        assertThrows(
                IllegalArgumentException.class,
                () -> ImagePictures.of(new Raster(1, 1), new Raster(1, 1), -1));
    }

    private static Raster image(int width, int height, IntBinaryOperator argb) {
        var image = new Raster(width, height);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) image.argb()[y * width + x] = argb.applyAsInt(x, y);
        return image;
    }
}
