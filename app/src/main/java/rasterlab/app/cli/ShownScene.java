package rasterlab.app.cli;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import rasterlab.engine.scene.Scene;
import rasterlab.exercises.scene.Setting;
import rasterlab.exercises.scene.Settings;

/**
 * A scene to render, with what its file says about how.
 *
 * @param scene seen first as the file says
 * @param said nothing for a scene that the lab has
 * @param image to lay on the faces, where the file names one
 * @param onCommandLine whether an option was given there
 */
record ShownScene(
        Scene scene, Settings said, Optional<Path> image, Predicate<String> onCommandLine) {
    /**
     * What counts for an option: the command line before the file, the file before the default.
     *
     * @param value from the command line, or else the default
     */
    <T> T option(String name, T value, Setting<T> setting) {
        return onCommandLine.test(name) ? value : said.get(setting).orElse(value);
    }

    /**
     * The same for an option without a default.
     *
     * @param value null where the command line has none
     */
    <T> Optional<T> option(T value, Setting<T> setting) {
        return Optional.ofNullable(value).or(() -> said.get(setting));
    }
}
