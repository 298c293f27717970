package rasterlab.app.model;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.BrokenFileException;
import rasterlab.engine.scene.obj.ObjModel;
import rasterlab.engine.scene.obj.ObjReader;
import rasterlab.engine.scene.obj.ObjScene;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.Texture;

/** A Wavefront model with the materials and textures in its folder. */
public final class ModelFile {
    private ModelFile() {}

    /**
     * @param notes told of what was passed over or changed
     * @throws Complaint naming file and line, if one cannot be read, is broken or lies elsewhere
     */
    public static Scene read(Path file, UpAxis up, Consumer<String> notes) {
        FileToRead.require(file, FileKind.MODEL);
        try {
            FileToRead.requireNoPicture(file, FileKind.MODEL);
            var folder = new OwnFolder(file);
            ObjModel model;
            try (Reader reader = text(file, FileKind.MODEL)) {
                model = ObjReader.read(file.toString(), reader, name -> opened(folder, name));
            }
            model.notes().forEach(notes);
            if (model.colors().length > 0)
                notes.accept(file + ": colours of vertices were passed over");
            return ObjScene.of(
                    file.getFileName().toString(),
                    model,
                    up,
                    (name, place) -> texture(file, folder, name, place));
        } catch (BrokenFileException e) {
            throw Complaint.badInput(e.getMessage());
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be read: " + WholeFile.reason(e));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(file + ": " + e.getMessage());
        }
    }

    private static Optional<Reader> opened(OwnFolder folder, String name) throws IOException {
        try {
            Optional<Path> found = folder.find(name);
            if (found.isEmpty()) return Optional.empty();
            return Optional.of(text(found.get(), FileKind.MATERIALS));
        } catch (Complaint e) {
            throw new IOException(e.getMessage(), e);
        } catch (IOException e) {
            throw new IOException(WholeFile.reason(e), e);
        }
    }

    /** Bytes that are no UTF-8 become a sign that stands for them; names only can have any. */
    private static Reader text(Path file, FileKind kind) throws IOException {
        return new BufferedReader(
                new InputStreamReader(FileToRead.stream(file, kind), StandardCharsets.UTF_8));
    }

    /**
     * @param place where it is named
     */
    private static Texture texture(Path model, OwnFolder folder, String name, String place) {
        try {
            return folder.picture(name).texture();
        } catch (Complaint e) {
            throw Complaint.badInput("%s: %s: %s".formatted(model, place, e.getMessage()));
        }
    }
}
