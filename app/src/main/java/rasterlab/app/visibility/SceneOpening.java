package rasterlab.app.visibility;

import java.nio.file.Path;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.KeptFile;
import rasterlab.app.canvas.LatestOnly;
import rasterlab.app.canvas.Settling;

/** Reads scenes in the background: those that the user opens, and those of an earlier run. */
final class SceneOpening implements Settling, AutoCloseable {
    private final VisibilityLabModel model;
    private final LatestOnly<SceneFiles.Task, SceneFiles.Answer> files;
    private final KeptFile<OpenedFiles, VisibilityChoice> kept;

    /**
     * @param events runs what it is given on the thread of the model
     * @param onFailure told what reading threw that is no fault of a file, on any thread
     */
    SceneOpening(VisibilityLabModel model, Executor events, Consumer<Throwable> onFailure) {
        this.model = model;
        files =
                new LatestOnly<>(
                        "scene file",
                        (task, cancelled) -> SceneFiles.done(task),
                        (task, answer) -> events.execute(() -> accept(task, answer)),
                        onFailure);
        kept =
                new KeptFile<>(
                        OpenedFiles.class,
                        () -> model.state().choice(),
                        OpenedFiles::of,
                        VisibilityChoice::shown,
                        this::read);
    }

    private boolean read(OpenedFiles opened, VisibilityChoice before) {
        return opened.read(view -> files.ask(SceneFiles.Task.of(new ComingBack(view, before))));
    }

    void open(Path file) {
        files.ask(SceneFiles.Task.of(file));
    }

    KeptFile<OpenedFiles, VisibilityChoice> kept() {
        return kept;
    }

    private void accept(SceneFiles.Task task, SceneFiles.Answer answer) {
        if (task.back().isPresent()) acceptBack(answer);
        else acceptOpened(answer);
    }

    private void acceptOpened(SceneFiles.Answer answer) {
        model.tellProblem(answer.problem());
        try {
            if (answer.problem().isEmpty()) model.choose(answer.change());
        } catch (IllegalArgumentException e) {
            model.tellProblem(e.getMessage());
        }
        if (model.state().problem().isEmpty()) kept.forget();
        else kept.again();
    }

    /** What was told of a file opened meanwhile is told on, unless there is a new problem. */
    private void acceptBack(SceneFiles.Answer answer) {
        if (kept.awaited().isEmpty()) return;
        VisibilityLabState state = model.state();
        String told = answer.problem().isEmpty() ? state.problem() : answer.problem();
        try {
            VisibilityChoice next = answer.change().apply(state.choice());
            if (!next.equals(state.choice())) model.bringBackOpened(next);
        } catch (IllegalArgumentException e) {
            told = e.getMessage();
        }
        model.tellProblem(told);
    }

    @Override
    public void settle() throws InterruptedException {
        files.settle();
    }

    @Override
    public void close() {
        files.close();
    }
}
