package rasterlab.exercises.drawing;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Encodes pictures as PNG. */
final class PngBytes {
    /** Bytes that a picture of a report should not exceed. */
    static final int MOST = 40_000;

    /** Numbers of colours for a picture that is too large in all of its own. */
    private static final int[] FEW = {16, 8};

    private PngBytes() {}

    /** The whole picture in all its colours. */
    static byte[] of(BufferedImage image) {
        return written(image, writer -> writer.getDefaultWriteParam());
    }

    /** A picture as PNG, compressed as far as PNG can be, which takes longer. */
    private static byte[] compressed(BufferedImage image) {
        return written(
                image,
                writer -> {
                    ImageWriteParam parameters = writer.getDefaultWriteParam();
                    parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
                    parameters.setCompressionQuality(0);
                    return parameters;
                });
    }

    private static byte[] written(
            BufferedImage image, Function<ImageWriter, ImageWriteParam> parameters) {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        var bytes = new ByteArrayOutputStream();
        // in memory: what ImageIO takes by itself may lie in a temporary file
        try (var out = new MemoryCacheImageOutputStream(bytes)) {
            writer.setOutput(out);
            writer.write(null, new IIOImage(image, null, null), parameters.apply(writer));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    /**
     * A picture as compressed PNG; one larger than {@link #MOST} keeps only its most important
     * colours.
     */
    static byte[] small(BufferedImage image) {
        byte[] bytes = of(image);
        for (int i = 0; i < FEW.length && bytes.length > MOST; i++)
            bytes = compressed(inFewColors(image, FEW[i]));
        return bytes;
    }

    /** The picture with each colour as the most similar of its inks and most frequent colours. */
    private static BufferedImage inFewColors(BufferedImage image, int most) {
        var counts = new HashMap<Integer, Integer>();
        int width = image.getWidth();
        int[] pixels = image.getRGB(0, 0, width, image.getHeight(), null, 0, width);
        for (int rgb : pixels) counts.merge(rgb, 1, Integer::sum);
        int[] colors =
                Stream.concat(
                                Ink.ALL.stream().map(Color::getRGB).filter(counts::containsKey),
                                counts.entrySet().stream()
                                        .sorted(
                                                Map.Entry.<Integer, Integer>comparingByValue()
                                                        .reversed()
                                                        .thenComparing(Map.Entry.comparingByKey()))
                                        .map(Map.Entry::getKey))
                        .distinct()
                        .limit(most)
                        .mapToInt(rgb -> rgb)
                        .toArray();
        var model =
                new IndexColorModel(4, colors.length, colors, 0, false, -1, DataBuffer.TYPE_BYTE);
        var few =
                new BufferedImage(width, image.getHeight(), BufferedImage.TYPE_BYTE_BINARY, model);
        var nearest = new HashMap<Integer, Integer>();
        for (int i = 0; i < pixels.length; i++)
            few.getRaster()
                    .setSample(
                            i % width,
                            i / width,
                            0,
                            nearest.computeIfAbsent(pixels[i], rgb -> nearest(rgb, colors)));
        return few;
    }

    private static int nearest(int rgb, int[] colors) {
        int best = 0;
        for (int i = 1; i < colors.length; i++)
            if (distance(rgb, colors[i]) < distance(rgb, colors[best])) best = i;
        return best;
    }

    private static int distance(int one, int other) {
        int sum = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            int difference = (one >> shift & 255) - (other >> shift & 255);
            sum += difference * difference;
        }
        return sum;
    }
}
