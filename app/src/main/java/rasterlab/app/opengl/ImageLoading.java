package rasterlab.app.opengl;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.opengl.state.GlChoice.ImageTexture;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.PictureFile;
import rasterlab.engine.texture.Texture;

/**
 * A texture from the image file that the user gave, or why there is none.
 *
 * @param image empty where there is a problem
 * @param problem in English, with the file's path
 */
record ImageLoading(Optional<ImageTexture> image, Optional<String> problem) {
    /**
     * @param limit the longest side that OpenGL takes here
     */
    static ImageLoading of(Path file, int limit) {
        try {
            return new ImageLoading(Optional.of(image(file, limit)), Optional.empty());
        } catch (Complaint refusal) {
            return new ImageLoading(Optional.empty(), Optional.of(refusal.getMessage()));
        }
    }

    /**
     * @throws Complaint naming the file and what is wrong with it
     */
    static ImageTexture image(Path file, int limit) {
        Texture texture = PictureFile.rgba(file, Math.min(limit, Texture.LARGEST));
        try {
            return new ImageTexture(file.toRealPath(), texture);
        } catch (IOException e) {
            throw Complaint.badInput(file + ": " + e);
        }
    }
}
