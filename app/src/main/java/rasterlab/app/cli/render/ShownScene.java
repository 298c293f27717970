package rasterlab.app.cli.render;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import rasterlab.app.model.SceneText;
import rasterlab.app.model.TextureChange;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.scene.Scene;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.Settings;

/**
 * A scene to render, with what its file says about how.
 *
 * @param scene seen first as the file says
 * @param settings nothing for a scene that the lab has
 * @param file that says it; empty for a scene that the lab has
 * @param onCommandLine whether an option was given there
 */
record ShownScene(
        Scene scene, Settings settings, Optional<Path> file, Predicate<String> onCommandLine) {
    /**
     * The value of an option: that of the command line before that of the file, and that before the
     * default.
     *
     * @param value from the command line, or else the default
     */
    <T> T option(String name, T value, SceneSetting<T> setting) {
        return onCommandLine.test(name) ? value : settings.get(setting).orElse(value);
    }

    /**
     * The value of an option without a default.
     *
     * @param value null where the command line has none
     */
    <T> Optional<T> option(T value, SceneSetting<T> setting) {
        return Optional.ofNullable(value).or(() -> settings.get(setting));
    }

    /**
     * The setting, if what counts for it stands in the file.
     *
     * @param value null where the command line has none
     */
    <T> Optional<SceneSetting<T>> ofFile(Object value, SceneSetting<T> setting) {
        boolean counts = value == null && settings.get(setting).isPresent();
        return counts ? Optional.of(setting) : Optional.empty();
    }

    /** Calls {@code make}; a refusal gets the setting's place in the file. */
    <T, R> R placed(Optional<SceneSetting<T>> setting, Supplier<R> make) {
        try {
            return make.get();
        } catch (IllegalArgumentException | Complaint e) {
            if (setting.isEmpty() || file.isEmpty()) throw e;
            throw Complaint.badInput(
                    file.get() + ": " + setting.get().place() + ": " + e.getMessage());
        }
    }

    /**
     * The scene with the picture that the file lays on its faces; empty where it names none.
     *
     * @throws Complaint naming the file and the path in it, if that cannot be done
     */
    Optional<Scene> covered(Scene scene) {
        return file.flatMap(
                from ->
                        SceneText.laid(
                                from,
                                settings,
                                (picture, texture) -> TextureChange.covered(scene, texture)));
    }
}
