package rasterlab.app.visibility;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.app.canvas.file.KeptFile;
import rasterlab.app.visibility.scene.OpenedFiles;
import rasterlab.app.visibility.scene.RestoredScene;
import rasterlab.app.visibility.scene.SceneChoice;
import rasterlab.app.visibility.scene.SceneFiles;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.scene.obj.UpAxis;

/** Shows the user's scenes, models and pictures in the lab. */
final class SceneOpening
        implements KeptFile.FileLab<OpenedFiles, VisibilityChoice, SceneFiles.SceneAnswer> {
    private final VisibilityLabModel model;

    SceneOpening(VisibilityLabModel model) {
        this.model = model;
    }

    @Override
    public Class<OpenedFiles> keptType() {
        return OpenedFiles.class;
    }

    @Override
    public VisibilityChoice shown() {
        return model.state().choice();
    }

    @Override
    public OpenedFiles files(VisibilityChoice shown) {
        return OpenedFiles.of(shown);
    }

    @Override
    public SceneChoice place(VisibilityChoice shown) {
        return shown.shown();
    }

    static Supplier<SceneFiles.SceneAnswer> reading(Path file) {
        return () -> SceneFiles.read(file);
    }

    /** Stands the shown model on another axis; its file is read again, and it can be undone. */
    static void stand(VisibilityLabModel model, UpAxis up) {
        SceneChoice shown = model.state().choice().shown();
        if (shown.up().filter(now -> now != up).isPresent())
            model.keptFiles().open(() -> SceneFiles.standing(shown, up));
    }

    @Override
    public Optional<Supplier<SceneFiles.SceneAnswer>> reading(
            OpenedFiles kept, VisibilityChoice before) {
        return kept.view()
                .map(view -> () -> SceneFiles.read(new RestoredScene(view, kept.up(), before)));
    }

    @Override
    public boolean open(SceneFiles.SceneAnswer read) {
        model.tellProblem(read.problem());
        try {
            if (read.problem().isEmpty()) model.choose(read.change());
        } catch (IllegalArgumentException e) {
            model.tellProblem(e.getMessage());
        }
        boolean shown = model.state().problem().isEmpty();
        if (shown && !read.notes().isEmpty()) model.tellProblem(read.notes());
        return shown;
    }

    @Override
    public String restore(OpenedFiles kept, SceneFiles.SceneAnswer read) {
        try {
            VisibilityChoice next = read.change().apply(shown());
            if (!next.equals(shown())) model.restoreOpened(next);
            return read.problem();
        } catch (IllegalArgumentException e) {
            return e.getMessage();
        }
    }

    @Override
    public String remark() {
        return model.state().problem();
    }

    @Override
    public void tell(String problem) {
        model.tellProblem(problem);
    }
}
