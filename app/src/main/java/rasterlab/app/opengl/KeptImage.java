package rasterlab.app.opengl;

import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.Setting;

/**
 * The user's image as it is kept between runs: by its place, for it may be another one by then.
 *
 * @param file empty where none was opened
 * @param shown whether it is the texture, and not only one that can be chosen
 */
record KeptImage(Optional<Path> file, boolean shown) {
    static KeptImage of(GlChoice choice) {
        return new KeptImage(
                choice.file().map(GlChoice.ImageTexture::file), choice.is(Setting.IMAGE, "file"));
    }
}
