package rasterlab.app.model;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Setting;
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
        FileToRead.require(file, "a scene");
        try {
            if (Files.size(file) > SceneFile.LONGEST)
                throw Complaint.badInput(
                        "%s: has %d bytes, a scene file has at most %d"
                                .formatted(file, Files.size(file), SceneFile.LONGEST));
            ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file));
            return SceneFile.read(StandardCharsets.UTF_8.newDecoder().decode(bytes).toString());
        } catch (CharacterCodingException e) {
            throw Complaint.badInput(file + ": is not UTF-8 text");
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be read: " + WholeFile.reason(e));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(file + ": " + e.getMessage());
        }
    }

    /**
     * The picture that a scene file lays on its faces; empty where it names none.
     *
     * @throws Complaint if it is not in the file's folder
     */
    public static Optional<Path> image(Path file, Settings settings) {
        Optional<String> name = settings.get(Setting.TEXTURE_IMAGE);
        if (name.isEmpty()) return Optional.empty();
        String place = file + ": " + Setting.TEXTURE_IMAGE.place();
        try {
            Optional<Path> found = new OwnFolder(file, place).find(name.get());
            if (found.isPresent()) return found;
        } catch (IOException e) {
            throw Complaint.badInput(
                    "%s: texture '%s' cannot be read: %s"
                            .formatted(place, name.get(), WholeFile.reason(e)));
        }
        throw Complaint.badInput(
                "%s: there is no texture '%s' in its folder".formatted(place, name.get()));
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
