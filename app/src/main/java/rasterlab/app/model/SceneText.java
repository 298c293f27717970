package rasterlab.app.model;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.texture.Texture;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Settings;

/** Scene files on disk. */
public final class SceneText {
    /** How their names end. */
    public static final String EXTENSION = ".scene.json";

    private SceneText() {}

    /**
     * @throws Complaint naming the file and the path in it
     */
    public static SceneView view(Path file) {
        if (read(file) instanceof SceneView view) return view;
        throw Complaint.badInput(
                file + ": holds an input of a topic; `./lab run --scene " + file + "` takes it");
    }

    /**
     * @throws Complaint naming the file and the path in it
     */
    public static MethodCase methodCase(Path file) {
        if (read(file) instanceof MethodCase one) return one;
        throw Complaint.badInput(
                file + ": holds a view of a scene; `./lab render " + file + "` takes it");
    }

    private static SceneFile read(Path file) {
        try {
            return SceneFile.read(FileToRead.text(file, FileKind.SCENE));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(file + ": " + e.getMessage());
        }
    }

    /**
     * The texture from the picture that a scene file lays on its faces; empty where it names none.
     *
     * @param lay takes the picture's file and its texels
     * @throws Complaint naming the file and the path in it, if the picture is not in the file's
     *     folder, cannot be read, or is refused by {@code lay}
     */
    public static <T> Optional<T> laid(
            Path file, Settings settings, BiFunction<Path, Texture, T> lay) {
        Optional<String> name = settings.get(SceneSetting.TEXTURE_IMAGE);
        if (name.isEmpty()) return Optional.empty();
        try {
            OwnFolder.LocatedPicture picture = new OwnFolder(file).picture(name.get());
            return Optional.of(lay.apply(picture.file(), picture.texture()));
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be read: " + WholeFile.reason(e));
        } catch (IllegalArgumentException | Complaint e) {
            throw Complaint.badInput(
                    "%s: %s: %s"
                            .formatted(file, SceneSetting.TEXTURE_IMAGE.place(), e.getMessage()));
        }
    }

    /** Writes a view whole or not at all. */
    public static void write(Path file, SceneView view) {
        WholeFile.requireWritable(file);
        WholeFile.write(file, (view.write() + "\n").getBytes(StandardCharsets.UTF_8));
    }

    /** The file with the ending of scene files, whether that was written or not. */
    public static Path named(Path file) {
        String path = file.toString();
        return Path.of(path.endsWith(EXTENSION) ? path : path + EXTENSION);
    }
}
