package rasterlab.exercises.drawing;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Encodes pictures as PNG. */
final class PngBytes {
    /** Bytes that a picture of a report should not exceed. */
    static final int MOST = 40_000;

    /** The levels of a channel in a picture that would be too large in all its colours. */
    private static final int LEVELS = 6;

    private PngBytes() {}

    /** The whole picture in all its colours. */
    static byte[] of(BufferedImage image) {
        var bytes = new ByteArrayOutputStream();
        // in memory: what ImageIO takes by itself may lie in a temporary file
        try (var out = new MemoryCacheImageOutputStream(bytes)) {
            if (!ImageIO.write(image, "png", out))
                throw new AssertionError("this JDK writes no PNG");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /** The same; where it is larger than {@link #MOST}, each channel rounded to a few levels. */
    static byte[] small(BufferedImage image) {
        byte[] bytes = of(image);
        return bytes.length <= MOST ? bytes : of(rounded(image));
    }

    private static BufferedImage rounded(BufferedImage image) {
        var colors = new int[LEVELS * LEVELS * LEVELS];
        for (int i = 0; i < colors.length; i++)
            colors[i] = rgb(i / LEVELS / LEVELS, i / LEVELS % LEVELS, i % LEVELS);
        var model =
                new IndexColorModel(
                        8,
                        colors.length,
                        colors,
                        0,
                        false,
                        -1,
                        java.awt.image.DataBuffer.TYPE_BYTE);
        var rounded =
                new BufferedImage(
                        image.getWidth(),
                        image.getHeight(),
                        BufferedImage.TYPE_BYTE_INDEXED,
                        model);
        for (int y = 0; y < image.getHeight(); y++)
            for (int x = 0; x < image.getWidth(); x++)
                rounded.getRaster().setSample(x, y, 0, index(image.getRGB(x, y)));
        return rounded;
    }

    private static int rgb(int red, int green, int blue) {
        int step = 255 / (LEVELS - 1);
        return red * step << 16 | green * step << 8 | blue * step;
    }

    private static int index(int rgb) {
        return (level(rgb >> 16) * LEVELS + level(rgb >> 8)) * LEVELS + level(rgb);
    }

    private static int level(int channel) {
        return ((channel & 255) * (LEVELS - 1) + 127) / 255;
    }
}
