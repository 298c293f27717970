package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import rasterlab.exercises.score.CasePicture;

/** Looks at the three pictures of a case. */
final class Seen {
    private final List<CasePicture> pictures;
    private final List<BufferedImage> images;

    Seen(List<CasePicture> pictures) {
        this.pictures = pictures;
        images = pictures.stream().map(Seen::decoded).toList();
    }

    BufferedImage expected() {
        return images.get(0);
    }

    BufferedImage actual() {
        return images.get(1);
    }

    BufferedImage difference() {
        return images.get(2);
    }

    String expectedText(String language) {
        return pictures.get(0).text().in(language);
    }

    String actualText(String language) {
        return pictures.get(1).text().in(language);
    }

    String differenceText(String language) {
        return pictures.get(2).text().in(language);
    }

    /** Fails unless there are three pictures of one size, small as files, each with a text. */
    void assertComplete(String message) {
        assertEquals(
                List.of("expected", "actual", "difference"),
                pictures.stream().map(CasePicture::kind).toList(),
                message);
        for (CasePicture one : pictures) {
            assertTrue(one.png().length <= PngBytes.MOST, message + ": " + one.png().length);
            for (String language : List.of("en", "ru"))
                assertFalse(one.text().in(language).isBlank(), message);
        }
        List<String> sizes =
                Stream.of(expected(), actual(), difference())
                        .map(image -> image.getWidth() + "×" + image.getHeight())
                        .distinct()
                        .toList();
        assertEquals(1, sizes.size(), message + ": " + sizes);
    }

    /** Number of pixels of exactly that colour. */
    static int count(BufferedImage image, Color color) {
        return count(image, color, new Rectangle2D.Double(0, 0, 1e9, 1e9));
    }

    /** The number of pixels of a colour within a part of the picture. */
    static int count(BufferedImage image, Color color, Rectangle2D part) {
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++)
            for (int x = 0; x < image.getWidth(); x++)
                if (part.contains(x, y) && image.getRGB(x, y) == color.getRGB()) count++;
        return count;
    }

    /** Whether two pictures of one size have a pixel in that part which differs. */
    static boolean differ(BufferedImage one, BufferedImage other, Rectangle2D part) {
        for (int y = 0; y < one.getHeight(); y++)
            for (int x = 0; x < one.getWidth(); x++)
                if (part.contains(x, y) && one.getRGB(x, y) != other.getRGB(x, y)) return true;
        return false;
    }

    private static BufferedImage decoded(CasePicture picture) {
        try {
            return ImageIO.read(new ByteArrayInputStream(picture.png()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
