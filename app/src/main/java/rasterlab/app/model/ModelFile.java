package rasterlab.app.model;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.TextEncoding;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.BrokenFileException;
import rasterlab.engine.scene.obj.ObjModel;
import rasterlab.engine.scene.obj.ObjReader;
import rasterlab.engine.scene.obj.ObjScene;
import rasterlab.engine.scene.obj.UpAxis;

/** A Wavefront model with the materials and textures in its folder. */
public final class ModelFile {
    private ModelFile() {}

    /**
     * @param notes told of what was passed over or changed
     * @throws Complaint naming file and line, if the model cannot be read or is broken
     */
    public static Scene read(Path file, UpAxis up, Consumer<String> notes) {
        FileToRead.require(file, FileKind.MODEL);
        try {
            FileToRead.requireNoPicture(file, FileKind.MODEL);
            var folder = new ModelFolder(file);
            ObjModel model = model(file, folder, notes);
            model.notes().forEach(notes);
            return ObjScene.of(
                    file.getFileName().toString(),
                    model,
                    up,
                    new ModelTextures(folder, notes),
                    notes);
        } catch (BrokenFileException e) {
            throw Complaint.badInput(e.getMessage());
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be read: " + WholeFile.reason(e));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(file + ": " + e.getMessage());
        }
    }

    /** A text is read as UTF-8 until it shows that it is none, and then once more. */
    private static ObjModel model(Path file, ModelFolder folder, Consumer<String> notes)
            throws IOException, BrokenFileException {
        TextEncoding begun = ModelText.begun(file);
        try {
            ObjModel model = model(file, folder, begun);
            if (begun != TextEncoding.UTF_8) notes.accept(readAs(file, begun));
            return model;
        } catch (CharacterCodingException e) {
            ObjModel model = model(file, folder, TextEncoding.WINDOWS_1251);
            notes.accept(readAs(file, TextEncoding.WINDOWS_1251));
            return model;
        }
    }

    private static String readAs(Path file, TextEncoding encoding) {
        return "%s: is %s text and was read as such".formatted(file, encoding);
    }

    private static ObjModel model(Path file, ModelFolder folder, TextEncoding encoding)
            throws IOException, BrokenFileException {
        try (Reader reader = ModelText.open(file, encoding)) {
            return ObjReader.read(file.toString(), reader, name -> materials(folder, name));
        }
    }

    private static Optional<Reader> materials(ModelFolder folder, String name) throws IOException {
        try {
            Optional<ModelFolder.FoundFile> found = folder.find(List.of(name));
            return found.isEmpty()
                    ? Optional.empty()
                    : Optional.of(ModelText.materials(found.get().file()));
        } catch (Complaint e) {
            throw new IOException(e.getMessage(), e);
        } catch (IOException e) {
            throw new IOException(WholeFile.reason(e), e);
        }
    }
}
