package rasterlab.app.model;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.scene.SceneView;

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
        if (Files.isDirectory(file)) throw Complaint.badInput(file + ": is a folder, not a scene");
        if (!Files.isReadable(file)) throw Complaint.badInput(file + ": no such file to read");
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

    /** The file with the ending of scene files, whether that was written or not. */
    public static Path named(Path file) {
        String path = file.toString();
        return Path.of(path.endsWith(EXTENSION) ? path : path + EXTENSION);
    }
}
