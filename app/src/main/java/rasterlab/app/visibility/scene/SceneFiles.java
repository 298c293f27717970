package rasterlab.app.visibility.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import rasterlab.app.model.ModelNotes;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.PictureFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.Texture;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Settings;

/** Scenes, models and textures from files, and views of scenes into files. */
public final class SceneFiles {
    /** The files that are opened, by the ends of their names, lower-case. */
    public static final List<String> ENDINGS =
            List.of(SceneText.EXTENSION, ".obj", ".png", ".jpg", ".jpeg", ".gif", ".bmp");

    private static final String MODEL = ".obj";

    private SceneFiles() {}

    /**
     * @param change what was read makes of the choice
     * @param problem in one line with the place in the file; "" if there was none
     * @param notes what is told of a file that is shown; "" for nothing
     */
    public record SceneAnswer(
            UnaryOperator<VisibilityChoice> change, String problem, String notes) {
        SceneAnswer(UnaryOperator<VisibilityChoice> change, String problem) {
            this(change, problem, "");
        }
    }

    /** The files that the user opens. */
    public static SceneAnswer read(Path file) {
        return read(
                file, () -> isModel(file) ? model(file) : new SceneAnswer(opened(file), ""), "");
    }

    /** The view that an earlier run showed. */
    public static SceneAnswer read(RestoredScene back) {
        return read(back.file(), back::read, back.instead());
    }

    private static SceneAnswer read(Path file, Supplier<SceneAnswer> reading, String instead) {
        try {
            return reading.get();
        } catch (Complaint complaint) {
            return new SceneAnswer(choice -> choice, complaint.getMessage() + instead);
        } catch (IllegalArgumentException e) {
            return new SceneAnswer(choice -> choice, file + ": " + e.getMessage() + instead);
        }
    }

    private static boolean isModel(Path file) {
        return lowerCase(file).endsWith(MODEL);
    }

    private static boolean isScene(Path file) {
        return lowerCase(file).endsWith(SceneText.EXTENSION);
    }

    private static String lowerCase(Path file) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    }

    private static UnaryOperator<VisibilityChoice> opened(Path file) {
        String name = lowerCase(file);
        if (isScene(file)) return seen(file, SceneText.view(file));
        if (Files.isDirectory(file)) FileToRead.require(file, FileKind.SCENE);
        if (!name.matches(".*\\.(png|jpe?g|gif|bmp)"))
            throw Complaint.badInput(
                    file
                            + ": unknown extension; allowed are .obj, "
                            + SceneText.EXTENSION
                            + ", .png, .jpg, .gif and .bmp");
        Texture texture = PictureFile.texture(file);
        return choice -> choice.with(choice.shown().covered(file, texture), choice.camera());
    }

    private static SceneAnswer model(Path file) {
        ModelNotes read = ModelNotes.read(file);
        SceneChoice model = SceneChoice.model(file, read.scene(), UpAxis.Y);
        return new SceneAnswer(choice -> choice.with(model), "", read.notes());
    }

    /** The model that is shown, with another axis up, as its file has it now; the eye stays. */
    public static SceneAnswer standing(SceneChoice shown, UpAxis up) {
        Path file = shown.file().orElseThrow();
        return read(
                file,
                () -> {
                    SceneChoice bare = scene(file, up);
                    SceneChoice next =
                            shown.image()
                                    .map(image -> bare.covered(image, PictureFile.texture(image)))
                                    .orElse(bare);
                    return new SceneAnswer(
                            now -> now.shown().equals(shown) ? now.with(next, now.camera()) : now,
                            "");
                },
                "");
    }

    /**
     * The scene of a scene file, or a model, without what a scene file says besides.
     *
     * @param up the axis of a model that points up
     * @throws Complaint naming the file and the place in it
     */
    static SceneChoice scene(Path file, UpAxis up) {
        return isScene(file)
                ? held(file, SceneText.view(file).source())
                : SceneChoice.model(file, ModelNotes.read(file, up).scene(), up);
    }

    private static SceneChoice held(Path file, SceneSource source) {
        return source instanceof SceneSource.ByName named && named.detail().isEmpty()
                ? SceneChoice.named(named.name())
                : SceneChoice.opened(file, source.scene());
    }

    private static UnaryOperator<VisibilityChoice> seen(Path file, SceneView view) {
        SceneChoice held = held(file, view.source());
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
    public static SavedScene save(Path file, VisibilityChoice choice) {
        Settings said = SavedView.of(choice);
        Optional<Path> image = choice.shown().image();
        if (image.isPresent())
            said = said.with(SceneSetting.TEXTURE_IMAGE, nameBeside(file, image.get()));
        SceneText.write(file, new SceneView(source(choice.shown()), said));
        return new SavedScene(file, choice.shown());
    }

    private static SceneSource source(SceneChoice shown) {
        boolean covered = shown.image().isPresent();
        if (shown.known() || covered && shown.file().isEmpty())
            return new SceneSource.ByName(shown.name(), OptionalInt.empty());
        if (!covered) return new SceneSource.Inline(shown.scene());
        return new SceneSource.Inline(
                shown.scene().with(f -> new Appearance(f.front(), f.back(), Optional.empty())));
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
