package rasterlab.app.visibility;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.UnaryOperator;
import rasterlab.app.model.ModelFile;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.PictureFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.scene.Finish;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.Texture;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Setting;
import rasterlab.exercises.scene.Settings;

/** Scenes, models and textures from files, and views of scenes into files. */
final class SceneFiles {
    /** What is opened by the ends of their names, lower-case. */
    static final List<String> ENDINGS =
            List.of(SceneText.EXTENSION, ".obj", ".png", ".jpg", ".jpeg");

    private static final String MODEL = ".obj";

    private SceneFiles() {}

    /**
     * A file to read, or to write.
     *
     * @param saved what is written; empty for a file to be read
     */
    record Task(Path file, Optional<VisibilityChoice> saved) {}

    /**
     * @param change what an opened file makes of the choice
     * @param problem in one line with the place in the file; "" if there was none
     */
    record Answer(UnaryOperator<VisibilityChoice> change, String problem) {}

    static Answer done(Task task) {
        try {
            if (task.saved.isEmpty()) return new Answer(opened(task.file), "");
            save(task.file, task.saved.get());
            return new Answer(choice -> choice, "");
        } catch (Complaint complaint) {
            return new Answer(choice -> choice, complaint.getMessage());
        } catch (IllegalArgumentException e) {
            return new Answer(choice -> choice, task.file + ": " + e.getMessage());
        }
    }

    private static UnaryOperator<VisibilityChoice> opened(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        if (name.endsWith(SceneText.EXTENSION)) return seen(file, SceneText.view(file));
        if (name.endsWith(MODEL)) {
            Scene model = ModelFile.read(file, UpAxis.Z, note -> {});
            return choice -> choice.with(SceneChoice.opened(file, model));
        }
        if (Files.isDirectory(file)) FileToRead.require(file, FileKind.SCENE);
        if (!name.matches(".*\\.(png|jpg|jpeg)"))
            throw Complaint.badInput(
                    file
                            + ": unknown extension; allowed are .obj, "
                            + SceneText.EXTENSION
                            + ", .png and .jpg");
        Texture texture = PictureFile.texture(file);
        return choice -> choice.with(choice.shown().covered(file, texture), choice.camera());
    }

    private static UnaryOperator<VisibilityChoice> seen(Path file, SceneView view) {
        SceneChoice held =
                view.source() instanceof SceneSource.ByName named && named.detail().isEmpty()
                        ? SceneChoice.named(named.name())
                        : SceneChoice.opened(file, view.source().scene());
        SceneChoice found = SceneText.laid(file, view.settings(), held::covered).orElse(held);
        return choice -> {
            try {
                VisibilityChoice next = SavedView.applied(choice, found, view.settings());
                next.plain(2, 1); // Refuses what cannot be drawn so.
                return next;
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(file + ": " + e.getMessage(), e);
            }
        };
    }

    /**
     * @throws Complaint if the file cannot be written
     */
    static SavedScene save(Path file, VisibilityChoice choice) {
        Settings said = SavedView.of(choice);
        Optional<Path> image = choice.shown().image();
        if (image.isPresent())
            said = said.with(Setting.TEXTURE_IMAGE, nameBeside(file, image.get()));
        SceneText.write(file, new SceneView(source(choice.shown()), said));
        return new SavedScene(file, choice.shown());
    }

    private static SceneSource source(SceneChoice shown) {
        boolean covered = shown.image().isPresent();
        if (shown.known() || covered && shown.file().isEmpty())
            return new SceneSource.ByName(shown.name(), OptionalInt.empty());
        if (!covered) return new SceneSource.Inline(shown.scene());
        return new SceneSource.Inline(
                shown.scene().with(f -> new Finish(f.front(), f.back(), Optional.empty())));
    }

    /** A scene file finds pictures in its own folder only. */
    private static String nameBeside(Path file, Path image) {
        try {
            Path folder = file.toAbsolutePath().getParent();
            if (Files.isDirectory(folder)
                    && Files.isSameFile(folder, image.toAbsolutePath().getParent()))
                return image.getFileName().toString();
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be written: " + WholeFile.reason(e));
        }
        throw Complaint.badInput(
                "%s: the picture on the faces, %s, lies in another folder; save the scene beside it"
                        .formatted(file, image));
    }
}
