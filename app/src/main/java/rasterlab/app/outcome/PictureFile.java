package rasterlab.app.outcome;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import rasterlab.engine.texture.Texture;

/** Pictures that textures are made of: PNG, JPEG, GIF and BMP, told by what is in the file. */
public final class PictureFile {
    private static final Set<String> FORMATS = Set.of("png", "jpeg", "gif", "bmp");

    private static final String ALLOWED = "; allowed are whole pictures as PNG, JPEG, GIF or BMP";

    /** The damage that the JPEG reader only warns of, and fills with grey. */
    private static final Pattern DAMAGED = Pattern.compile("Premature end|Corrupt");

    private PictureFile() {}

    /**
     * Reads a picture; one that is too large is refused before its pixels are read.
     *
     * @return with the components of {@link FileLevels#components}
     * @throws Complaint naming the file, if there is no such file, or it is no picture, broken or
     *     too large
     */
    public static Texture texture(Path file) {
        BufferedImage image = read(file, Texture.LARGEST);
        return texture(image, FileLevels.components(image));
    }

    /**
     * Reads a picture in colour with alpha, whatever the file has.
     *
     * @param most pixels on a side
     */
    public static Texture rgba(Path file, int most) {
        return texture(read(file, most), 4);
    }

    private static Texture texture(BufferedImage image, int components) {
        int width = image.getWidth();
        int height = image.getHeight();
        var texels = new int[width * height];
        for (int y = 0; y < height; y++) FileLevels.row(image, y, texels, (height - 1 - y) * width);
        return Texture.of(width, height, components, texels);
    }

    private static BufferedImage read(Path file, int most) {
        FileToRead.require(file, FileKind.PICTURE);
        if (file.toFile().length() == 0) throw refused(file, PictureFault.EMPTY);
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            ImageReader reader =
                    reader(in)
                            .orElseThrow(() -> refused(file, "is not a picture that can be read"));
            return read(file, reader, in, most);
        } catch (IOException | RuntimeException e) {
            // Readers throw exceptions of all kinds at broken files.
            if (e instanceof Complaint complaint) throw complaint;
            throw refused(file, PictureFault.of(file, e));
        }
    }

    private static Complaint refused(Path file, String reason) {
        return Complaint.badInput(file + ": " + reason + ALLOWED);
    }

    private static Optional<ImageReader> reader(ImageInputStream in) {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
        while (readers.hasNext()) {
            ImageReader reader = readers.next();
            String[] names = reader.getOriginatingProvider().getFormatNames();
            if (Stream.of(names).anyMatch(name -> FORMATS.contains(name.toLowerCase(Locale.ROOT))))
                return Optional.of(reader);
            reader.dispose();
        }
        return Optional.empty();
    }

    private static BufferedImage read(Path file, ImageReader reader, ImageInputStream in, int most)
            throws IOException {
        try {
            reader.setInput(in);
            int width = reader.getWidth(0);
            int height = reader.getHeight(0);
            if (width > most || height > most)
                throw Complaint.badInput(
                        "%s: has %d×%d pixels; a texture has from 1×1 to %d×%d"
                                .formatted(file, width, height, most, most));
            List<String> damage = new ArrayList<>();
            reader.addIIOReadWarningListener(
                    (from, warning) -> {
                        if (DAMAGED.matcher(warning).find()) damage.add(warning);
                    });
            BufferedImage picture = reader.read(0);
            if (!damage.isEmpty()) throw new IOException(damage.get(0));
            return picture;
        } finally {
            reader.dispose();
        }
    }
}
