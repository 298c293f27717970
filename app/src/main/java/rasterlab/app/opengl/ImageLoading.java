package rasterlab.app.opengl;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import rasterlab.app.opengl.state.GlChoice.ImageTexture;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.PixelLevels;
import rasterlab.engine.texture.Texture;

/**
 * A texture from the image file that the user gave, or why there is none.
 *
 * @param image empty where there is a problem
 */
record ImageLoading(Optional<ImageTexture> image, Optional<ImageProblem> problem) {
    /**
     * @param limit the longest side that OpenGL takes here
     */
    static ImageLoading of(Path file, int limit) {
        String name = String.valueOf(file.getFileName());
        Optional<String> obstacle = FileToRead.obstacle(file, FileKind.PICTURE);
        if (obstacle.isPresent())
            return refused(ImageProblem.of("unreadable", name, obstacle.get()));
        try (ImageInputStream stream = ImageIO.createImageInputStream(file.toFile())) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
            if (!readers.hasNext()) return refused(ImageProblem.of("unknown", name));
            ImageReader reader = readers.next();
            try {
                reader.setInput(stream);
                return read(reader, file, Math.min(limit, Texture.LARGEST));
            } finally {
                reader.dispose();
            }
        } catch (IOException | RuntimeException e) {
            // Readers throw exceptions of all kinds at broken files.
            return refused(ImageProblem.of("broken", name, String.valueOf(e.getMessage())));
        }
    }

    private static ImageLoading read(ImageReader reader, Path file, int limit) throws IOException {
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        if (width > limit || height > limit)
            return refused(
                    ImageProblem.of(
                            "large", String.valueOf(file.getFileName()), width, height, limit));
        BufferedImage image = reader.read(0);
        int[] texels = new int[width * height];
        for (int y = 0; y < height; y++)
            PixelLevels.row(image, y, texels, (height - 1 - y) * width);
        var texture = Texture.of(width, height, 4, texels);
        var loaded = new ImageTexture(file.toRealPath(), texture);
        return new ImageLoading(Optional.of(loaded), Optional.empty());
    }

    private static ImageLoading refused(ImageProblem problem) {
        return new ImageLoading(Optional.empty(), Optional.of(problem));
    }
}
