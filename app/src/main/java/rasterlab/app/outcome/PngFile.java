package rasterlab.app.outcome;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Pictures as PNG. */
public final class PngFile {
    /**
     * The bytes that every PNG begins with. Source: W3C, Portable Network Graphics, section 5.2.
     */
    private static final int[] SIGNATURE = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

    private PngFile() {}

    public static byte[] bytes(BufferedImage picture) {
        var bytes = new ByteArrayOutputStream();
        // By default ImageIO would write by way of a temporary file of its own.
        try (var out = new MemoryCacheImageOutputStream(bytes)) {
            ImageIO.write(picture, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException("memory cannot be written to", e);
        }
        return bytes.toByteArray();
    }

    /**
     * Reads a picture of exactly that size; one of another size is refused before its pixels are
     * read.
     *
     * @throws Complaint if there is no such file, or it is no PNG, broken, or of another size
     */
    public static BufferedImage read(Path file, int width, int height) {
        FileToRead.require(file, FileKind.PICTURE);
        if (file.toFile().length() == 0) throw refused(file, PictureFault.EMPTY);
        ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            requireSignature(file, in);
            reader.setInput(in);
            requireSize(file, reader, width, height);
            return reader.read(0);
        } catch (IOException | RuntimeException e) {
            if (e instanceof Complaint complaint) throw complaint;
            throw refused(file, PictureFault.of(file, e));
        } finally {
            reader.dispose();
        }
    }

    private static Complaint refused(Path file, String reason) {
        return Complaint.badInput(file + ": " + reason + "; expected a whole PNG picture");
    }

    /** Tells a cut-off signature from another file's start, which not every Java's reader does. */
    private static void requireSignature(Path file, ImageInputStream in) throws IOException {
        in.mark();
        for (int expected : SIGNATURE) {
            int read = in.read();
            if (read < 0) throw new EOFException();
            if (read != expected) throw Complaint.badInput(file + ": is not a PNG picture");
        }
        in.reset();
    }

    private static void requireSize(Path file, ImageReader reader, int width, int height)
            throws IOException {
        if (reader.getWidth(0) != width || reader.getHeight(0) != height)
            throw Complaint.badInput(
                    "%s: has %d×%d pixels, the rendered picture %d×%d; sizes must be equal"
                            .formatted(
                                    file, reader.getWidth(0), reader.getHeight(0), width, height));
    }
}
