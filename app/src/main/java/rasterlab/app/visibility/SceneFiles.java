package rasterlab.app.visibility;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.UnaryOperator;
import rasterlab.app.model.ModelFile;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.PictureFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.Texture;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;

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
        SceneChoice found =
                view.source() instanceof SceneSource.ByName named && named.detail().isEmpty()
                        ? SceneChoice.named(named.name())
                        : SceneChoice.opened(file, view.source().scene());
        return choice -> {
            VisibilityChoice next = choice.with(found);
            if (view.camera().isPresent()) next = next.withCamera(view.camera().get());
            if (view.projection().isPresent()) next = next.withProjection(view.projection().get());
            if (view.visibility().isPresent()) next = next.withVisibility(view.visibility().get());
            if (view.shading().isPresent()) next = next.withShading(view.shading().get());
            if (view.texture().isPresent())
                next = next.with(next.look().withTexture(TextureMode.named(view.texture().get())));
            return next;
        };
    }

    private static void save(Path file, VisibilityChoice choice) {
        SceneChoice shown = choice.shown();
        SceneSource source =
                shown.known()
                        ? new SceneSource.ByName(shown.name(), OptionalInt.empty())
                        : new SceneSource.Inline(shown.scene());
        var view =
                new SceneView(
                        source,
                        Optional.of(choice.camera()),
                        Optional.of(choice.projection()),
                        Optional.of(choice.visibility()),
                        Optional.of(choice.shading()),
                        Optional.of(choice.look().texture().code()));
        WholeFile.requireWritable(file);
        WholeFile.write(file, (view.write() + "\n").getBytes(StandardCharsets.UTF_8));
    }
}
