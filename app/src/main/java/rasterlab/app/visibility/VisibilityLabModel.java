package rasterlab.app.visibility;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.file.KeptFile;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestReading;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.row.RowLabModel;
import rasterlab.app.visibility.scene.Cameras;
import rasterlab.app.visibility.scene.OpenedFiles;
import rasterlab.app.visibility.scene.SavedScene;
import rasterlab.app.visibility.scene.SceneFiles;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Visibility;

/**
 * The hidden-surface lab without its window: what is drawn, how, from where.
 *
 * <p>Pictures are made on threads of the model's own; answers and commands all run on the thread of
 * the executor it is given. Each change publishes a new immutable {@link VisibilityLabState}.
 */
public final class VisibilityLabModel implements Kept<VisibilityChoice>, AutoCloseable {
    private final OwnMethods own;
    private final StageWork work;
    private final History<VisibilityChoice> history =
            new History<>(() -> state().choice(), choice -> draw(choice, true));
    private final FrameTimes times = new FrameTimes();
    private final Listeners<VisibilityLabState> listeners = new Listeners<>();
    private final LatestReading reader;
    private final KeptFile<OpenedFiles, VisibilityChoice, SceneFiles.SceneAnswer> files;
    private final ChartStudies charts;
    private final ViewBills bills;
    private final RowLabModel rows;
    private Optional<Frame> compared = Optional.empty();
    private String ownTopic = "depth-order";
    private StagePictures stage;
    private VisibilityLabState state = VisibilityLabState.of(VisibilityChoice.first());
    private Optional<SavedScene> saved = Optional.empty();

    /**
     * @param maker closed with the model, when it draws no more
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what a background picture threw, on any thread
     */
    public VisibilityLabModel(
            OwnMethods own, PictureMaker maker, Executor events, Consumer<Throwable> onFailure) {
        this.own = own;
        charts = new ChartStudies(events, onFailure);
        bills = new ViewBills(events, onFailure, this::refute);
        rows = RowLabModel.ofDepths(own, events, onFailure);
        stage =
                new StagePictures(
                        Renderer.visibilityMethods(), OwnVisibility.of(own, ownTopic), 0, 0);
        work =
                new StageWork(
                        maker,
                        events,
                        onFailure,
                        new StageWork.StageListeners(
                                this::accept, this::accept, this::accept, this::accept));
        reader = new LatestReading("scene file", events, onFailure);
        files = new KeptFile<>(new SceneOpening(this), reader);
    }

    public VisibilityLabState state() {
        return state;
    }

    public List<Method<Visibility>> methods() {
        return stage.methods();
    }

    /** Whether the chosen method draws a picture only as a whole: nobody can step through it. */
    boolean lacksSteps() {
        return methods().stream()
                .filter(method -> method.name().equals(state.choice().visibility()))
                .anyMatch(method -> !(method.implementation() instanceof SteppedVisibility));
    }

    /** Zoom by which the pictures are drawn: the chosen one, but that two pictures are filled. */
    double shownZoom() {
        return stage.known() ? stage.filling(state.choice()).zoom() : state.choice().zoom();
    }

    /** The charts that the stage can show instead of pictures. */
    ChartStudies charts() {
        return charts;
    }

    /** The counted and measured work of the picture. */
    ViewBills bills() {
        return bills;
    }

    /** Whether the chosen method can draw the faces' edges. */
    public boolean canDrawEdges() {
        return stage.canDrawEdges(state.choice().visibility());
    }

    /** Whether a picture of the present choice by that method has edges. */
    boolean drawsEdges(String method) {
        return stage.drawsEdges(state.choice(), method);
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<VisibilityLabState> listener) {
        return listeners.add(listener);
    }

    /**
     * Sets the size of the stage, in device pixels, from 1 to {@link Raster#LARGEST_SIDE}; before
     * the first call nothing is drawn.
     */
    public void resize(int newWidth, int newHeight) {
        StagePictures sized = stage.sized(newWidth, newHeight);
        if (sized.equals(stage)) return;
        Raster.checkSize(newWidth, newHeight);
        stage = sized;
        times.clear();
        draw(state.choice(), true);
    }

    /** Says why a file was not opened as asked; "" if it was. */
    void tellProblem(String problem) {
        publish(state.withProblem(problem));
    }

    /** Says beside the present scene in what it is other than a hazard. */
    public void tell(HazardNote note) {
        publish(state.with(note));
    }

    /**
     * Shows scenes, which the user's program on that topic may draw; it may be another by now.
     *
     * @param topic {@code visible-faces} or {@code depth-order}
     */
    void enterOwn(String topic) {
        rows.close();
        ownTopic = topic;
        stage = stage.withOwn(OwnVisibility.of(own, topic));
    }

    /** The topic of the user's program that may draw. */
    String ownTopic() {
        return ownTopic;
    }

    /** The tab's other lab: rows of depths. */
    public RowLabModel rows() {
        return rows;
    }

    /**
     * Changes the choice and remembers the old one.
     *
     * @throws IllegalArgumentException if the engine does not know a chosen name
     */
    public void choose(UnaryOperator<VisibilityChoice> change) {
        change(change, true);
    }

    private void change(UnaryOperator<VisibilityChoice> change, boolean counted) {
        VisibilityChoice next = change.apply(state.choice());
        if (!state.problem().isEmpty()) tellProblem("");
        if (next.equals(state.choice())) return;
        next.plain(2, 1); // Refuses unknown names before anything is remembered.
        if (!next.comparison().isEmpty()) next.plain(next.comparison(), 2, 1);
        history.remember();
        draw(next, counted);
    }

    /** Compares in the scene's own colours, unmarked. */
    public void compareColors(String scene, String method, String comparison) {
        choose(choice -> choice.comparing(scene, method, comparison).inOwnColors());
    }

    /** Lets the timeline go through the method's steps, or turn the scene. */
    public void watchSteps(boolean watched) {
        choose(choice -> choice.withDrawing(watched));
    }

    /** Turns the eye by angles in radians; φ stays in [0, 2π) and so does θ. */
    public void turn(double dTheta, double dPhi) {
        change(choice -> choice.withCamera(Cameras.turned(choice.camera(), dTheta, dPhi)), false);
    }

    /** Moves the eye away by a factor, within the distances that suit the scene. */
    public void dolly(double factor) {
        change(choice -> choice.withCamera(Cameras.dollied(choice, factor)), false);
    }

    /** Brings the eye to a place. */
    public void look(SphericalView camera) {
        change(choice -> choice.withCamera(camera), false);
    }

    /** Enlarges the picture by a factor. */
    public void zoom(double factor) {
        change(choice -> choice.zoomed(factor), false);
    }

    public void beginDrag() {
        history.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        publish(state);
        count();
    }

    /** Counts the wrong pixels and the work of a view after which no other follows at once. */
    void count() {
        if (compared.isPresent() || !stage.known()) return;
        compared = Optional.of(stage.plain(state.choice()));
        if (state.choice().tolerance().isEmpty()) compared.ifPresent(work::compare);
        bills.ask(stage.request(state.choice(), state.choice().visibility()), state);
    }

    private void refute(Plan plan) {
        work.refute(plan);
        draw(state.choice(), true);
    }

    public History<VisibilityChoice> history() {
        return history;
    }

    /** Returns to the first scene, view and methods; can be undone. */
    public void reset() {
        publish(state.choosing(Optional.empty()));
        choose(choice -> VisibilityChoice.first());
    }

    /** Shows the picture after so many steps; more than there are show all of it. */
    void goTo(int step) {
        int next = step >= lastStep() ? Frame.ALL : Math.max(0, step);
        if (next == state.step()) return;
        publish(state.at(next).withProblem(""));
        if (stage.known()) work.draw(stage.frame(state.choice(), state.step()));
    }

    /** How many steps the method made; 0 while that is not known. */
    int lastStep() {
        return state.drawn().map(drawn -> drawn.steps().size()).orElse(0);
    }

    /** Asks what happened at a pixel; one outside goes to the nearest one. */
    void choosePixel(ChosenPixel pixel) {
        if (!stage.known()) return;
        publish(state.choosing(Optional.of(stage.nearest(state.choice(), pixel))));
        askPixel();
    }

    /** Moves the chosen pixel; without one, to the middle. */
    void movePixel(int right, int down) {
        choosePixel(
                state.chosen()
                        .map(at -> new ChosenPixel(at.second(), at.x() + right, at.y() + down))
                        .orElseGet(() -> stage.middle(state.choice())));
    }

    /** Opens a scene, a model or a texture; what goes wrong is told in the state. */
    public void open(Path file) {
        files.open(SceneOpening.reading(file));
    }

    void keep(SavedScene scene) {
        saved = Optional.of(scene);
        publish(state);
    }

    /** The file that a scene was saved into last. */
    Optional<SavedScene> saved() {
        return saved;
    }

    @Override
    public Class<VisibilityChoice> keptType() {
        return VisibilityChoice.class;
    }

    /** The choice, with a scene of the lab where one is shown that no name brings back. */
    @Override
    public VisibilityChoice kept() {
        return state.choice().withoutFiles();
    }

    @Override
    public void restore(VisibilityChoice choice) {
        choice.plain(1, 1); // Refuses unknown names.
        draw(choice, true);
    }

    /** Shows what was kept of the user's files; there is nothing to undo afterwards. */
    void restoreOpened(VisibilityChoice choice) {
        draw(choice, true);
        history.forget();
    }

    /** The user's files that are shown; they are restored after the choice itself. */
    public KeptFile<OpenedFiles, VisibilityChoice, SceneFiles.SceneAnswer> keptFiles() {
        return files;
    }

    /** Waits until the pictures of every choice so far are made or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        reader.settle();
        work.settle();
        charts.settle();
        bills.settle();
        rows.settle();
    }

    /** Ends the threads. */
    @Override
    public void close() {
        work.close();
        reader.close();
        charts.close();
        bills.close();
        rows.end();
    }

    /**
     * @param counted whether unmarked wrong pixels are counted, which is slower than turning
     */
    private void draw(VisibilityChoice choice, boolean counted) {
        VisibilityChoice old = state.choice();
        boolean other = !choice.visibility().equals(old.visibility());
        boolean moved = !choice.shown().equals(old.shown());
        if (other || moved) times.clear();
        boolean keepsStep = choice.drawing() && !other && !moved;
        boolean keepsSteps = keepsStep && stage.watchesSteps(choice) && stage.watchesSteps(old);
        VisibilityLabState next = state.with(choice).at(keepsStep ? state.step() : Frame.ALL);
        publish(keepsSteps ? next : next.withDrawn(Optional.empty()));
        work.cancelTelling();
        bills.cancel();
        if (!stage.known()) return;
        work.draw(stage.frame(choice, state.step()));
        compared = Optional.empty();
        if (counted || choice.difference()) count();
        if (stage.watchesSteps(choice)) work.walk(stage.request(choice, choice.visibility()));
        askPixel();
    }

    private void askPixel() {
        state.chosen()
                .flatMap(pixel -> stage.question(state.choice(), pixel))
                .ifPresent(work::report);
    }

    private void accept(Frame.FramePictures made) {
        Picture first = made.first();
        boolean timed = first.refusal().isEmpty() && state.choice().view() == StageView.COLORS;
        if (timed && first.request().visibility().equals(state.choice().visibility()))
            times.add(first.nanos());
        publish(state.with(made));
        if (compared.isPresent()) bills.measure(state);
    }

    private void accept(Frame frame, Differences found) {
        if (compared.filter(asked -> asked == frame).isPresent()) publish(state.with(found));
    }

    private void accept(RenderRequest request, Optional<Drawn> found) {
        if (stage.watchesSteps(state.choice())) publish(state.withDrawn(found));
    }

    private void accept(PixelReport found) {
        if (state.chosen().filter(found.asked()::isAt).isPresent())
            publish(state.with(Optional.of(found)));
    }

    private void publish(VisibilityLabState next) {
        state = next.measured(times.median());
        listeners.tell(state);
    }
}
