package rasterlab.app.outcome;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import rasterlab.engine.texture.Texture;

/** Pictures that textures are made of: PNG and JPEG. */
public final class PictureFile {
    /** What the JPEG reader only warns of, and fills with grey. */
    private static final Pattern DAMAGED = Pattern.compile("Premature end|Corrupt");

    private PictureFile() {}

    /**
     * Reads a picture; one that is too large is refused before its pixels are read.
     *
     * @return with the components of {@link PixelLevels#components}
     * @throws Complaint if there is no such file, or it is no picture, broken or too large
     */
    public static Texture texture(Path file) {
        BufferedImage image = read(file);
        int width = image.getWidth();
        int height = image.getHeight();
        var texels = new int[width * height];
        for (int y = 0; y < height; y++)
            PixelLevels.row(image, y, texels, (height - 1 - y) * width);
        return Texture.of(width, height, PixelLevels.components(image), texels);
    }

    private static BufferedImage read(Path file) {
        FileToRead.require(file, FileKind.PICTURE);
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext())
                throw Complaint.badInput(file + ": is not a PNG or JPEG picture");
            return read(file, readers.next(), in);
        } catch (IOException | RuntimeException e) {
            if (e instanceof Complaint complaint) throw complaint;
            throw Complaint.badInput(file + ": is a broken picture: " + e.getMessage());
        }
    }

    private static BufferedImage read(Path file, ImageReader reader, ImageInputStream in)
            throws IOException {
        try {
            reader.setInput(in);
            int width = reader.getWidth(0);
            int height = reader.getHeight(0);
            if (width > Texture.LARGEST || height > Texture.LARGEST)
                throw Complaint.badInput(
                        "%s: has %d×%d pixels; a texture has from 1×1 to %d×%d"
                                .formatted(file, width, height, Texture.LARGEST, Texture.LARGEST));
            var damage = new ArrayList<String>();
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
