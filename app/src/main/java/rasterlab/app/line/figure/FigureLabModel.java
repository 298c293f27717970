package rasterlab.app.line.figure;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * The model of all that the lab of lines draws besides segments: circles, ellipses, lines of a pen,
 * and how bright lines are.
 *
 * <p>Drawing runs on a thread of the model's own; answers and commands all run on the thread of the
 * executor it is given. Each change publishes a new immutable {@link FigureState}.
 */
public final class FigureLabModel
        implements Kept<FigureLabModel.FigureScenes>, Steps, AutoCloseable {
    private final FigureTopics topics;
    private final LatestOnly<FigureScene, FigureDrawings> drawings;
    private final History<Remembered> history = new History<>(this::present, this::bring);
    private final Map<LineMode, FigureScene> scenes = new EnumMap<>(LineMode.class);
    private final Listeners<FigureState> listeners = new Listeners<>();
    private FigureState state;

    /** Arrangements so far, and what was sought; those that undo brings back are none. */
    private int arrangements;

    private int soughts;

    /** A lab for a user without own programs. */
    public FigureLabModel(Executor events, Consumer<Throwable> onFailure) {
        this(new OwnMethods(), events, onFailure);
    }

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what drawing threw, on any thread
     */
    public FigureLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        topics = new FigureTopics(own);
        for (LineMode mode : LineMode.values())
            if (mode != LineMode.SEGMENT) scenes.put(mode, FigureScene.first(mode));
        FigureScene first = scenes.get(LineMode.CIRCLE);
        FigureDrawings drawn = FigureDrawings.of(topics, first);
        state = new FigureState(first, drawn, drawn.drawing().steps(), 0, 0);
        drawings =
                new LatestOnly<>(
                        "figure",
                        (scene, cancelled) -> FigureDrawings.of(topics, scene),
                        (scene, newest) -> events.execute(() -> accept(newest)),
                        onFailure);
    }

    /**
     * The figure of every mode.
     *
     * @param last the mode that was shown last
     */
    record FigureScenes(LineMode last, Map<LineMode, FigureScene> scenes) {
        FigureScenes {
            scenes = Map.copyOf(scenes);
        }
    }

    /** The state that undo restores, with the numbers that brought it into sight. */
    private record Remembered(FigureScenes scenes, int arrangement, int sought) {}

    public FigureState state() {
        return state;
    }

    public List<String> methods(LineMode mode) {
        return topics.methods(mode);
    }

    /** The chosen method; empty where the pen draws. */
    public Optional<Method<?>> method() {
        return topics.of(state.scene().mode())
                .map(topic -> topics.method(topic, state.scene().method()));
    }

    public List<? extends Hazard<?>> hazards(LineMode mode) {
        return topics.hazards(mode);
    }

    /** The most pixels of a circle or an ellipse that methods are judged by. */
    int mostJudged() {
        return topics.mostJudged();
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<FigureState> listener) {
        return listeners.add(listener);
    }

    /**
     * Shows another mode, with the figure it had.
     *
     * @throws IllegalArgumentException for a segment, which has a lab of its own
     */
    public void chooseMode(LineMode mode) {
        if (!scenes.containsKey(mode))
            throw new IllegalArgumentException(mode + " is none of " + scenes.keySet());
        change(scenes.get(mode), true);
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        require(method);
        change(state.scene().withMethod(method), false);
    }

    /**
     * @param method a method's name, "" for none
     * @throws IllegalArgumentException naming the methods there are
     */
    public void compareWith(String method) {
        if (!method.isEmpty()) require(method);
        change(state.scene().withComparison(method), false);
    }

    private void require(String method) {
        require(state.scene().mode(), method);
    }

    private void require(LineMode mode, String method) {
        topics.method(
                topics.of(mode)
                        .orElseThrow(() -> new IllegalArgumentException("a pen has no methods")),
                method);
    }

    /**
     * Brings a hazard's circle or ellipse.
     *
     * @throws IllegalArgumentException naming the hazards there are
     */
    public void show(LineMode mode, String hazard) {
        change(scenes.get(mode).with(topics.showing(mode, hazard)), true);
    }

    public void show(Circle circle) {
        change(scenes.get(LineMode.CIRCLE).with(ArcFigure.of(circle)), true);
    }

    public void show(Ellipse ellipse) {
        change(scenes.get(LineMode.ELLIPSE).with(ArcFigure.of(ellipse)), true);
    }

    /**
     * Moves a point of the figure. Between {@link #beginDrag} and {@link #endDrag} all moves are
     * one for undo.
     */
    public void move(String grip, double pixelX, double pixelY) {
        figure(old -> old.moved(grip, new RasterPoint(pixelX, pixelY)));
    }

    void add(double pixelX, double pixelY) {
        figure(old -> old.added(new RasterPoint(pixelX, pixelY)));
    }

    void remove(String grip) {
        figure(old -> old.without(grip));
    }

    private void figure(UnaryOperator<DrawnFigure> changed) {
        change(state.scene().with(changed.apply(state.scene().figure())), false);
    }

    /** Changes a number of a circle or an ellipse, which the sight then follows. */
    public void arc(UnaryOperator<ArcFigure> changed) {
        if (!(state.scene().figure() instanceof ArcFigure old)) return;
        FigureScene next = state.scene().with(changed.apply(old));
        if (next.equals(state.scene())) return;
        history.remember();
        draw(next, state.arrangement(), ++soughts);
    }

    /** Changes something that only a pen's line has. */
    public void pen(UnaryOperator<PenFigure> changed) {
        if (state.scene().figure() instanceof PenFigure old)
            change(state.scene().with(changed.apply(old)), false);
    }

    void beginDrag() {
        history.beginDrag();
    }

    void endDrag() {
        history.endDrag();
        publish(at(state.step()));
    }

    /** A mode that is not shown may have been given a hazard's figure too. */
    private void bring(Remembered earlier) {
        scenes.putAll(earlier.scenes().scenes());
        FigureScene shown = scenes.get(earlier.scenes().last());
        draw(shown, earlier.arrangement(), earlier.sought());
    }

    private Remembered present() {
        return new Remembered(kept(), state.arrangement(), state.sought());
    }

    /** The choices that can be undone and redone. */
    public History<?> history() {
        return history;
    }

    /** Returns to the mode's first figure and method; can be undone. */
    public void reset() {
        change(FigureScene.first(state.scene().mode()), true);
    }

    @Override
    public Class<FigureScenes> keptType() {
        return FigureScenes.class;
    }

    @Override
    public FigureScenes kept() {
        return new FigureScenes(state.scene().mode(), scenes);
    }

    @Override
    public void restore(FigureScenes choice) {
        if (!choice.scenes().keySet().equals(scenes.keySet()))
            throw new IllegalArgumentException(
                    "the modes must be " + scenes.keySet() + ", got " + choice.scenes().keySet());
        choice.scenes().forEach(this::require);
        scenes.putAll(choice.scenes());
        draw(choice.scenes().get(choice.last()), arranged(true));
    }

    private void require(LineMode mode, FigureScene scene) {
        if (scene.mode() != mode)
            throw new IllegalArgumentException(mode + " has a scene of " + scene.mode());
        for (String method : List.of(scene.method(), scene.comparison()))
            if (!method.isEmpty()) require(mode, method);
    }

    /** Waits until every choice so far is drawn or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        drawings.settle();
    }

    /** Ends the thread. */
    @Override
    public void close() {
        drawings.close();
    }

    @Override
    public int first() {
        return Math.min(1, last());
    }

    @Override
    public int last() {
        return state.drawing().steps();
    }

    @Override
    public int step() {
        return state.step();
    }

    @Override
    public void goTo(int step) {
        int next = within(step);
        if (next != state.step()) publish(at(next));
    }

    private void change(FigureScene next, boolean arrange) {
        if (next.equals(state.scene()) && !arrange) return;
        if (!next.equals(state.scene())) history.remember();
        draw(next, arranged(arrange));
    }

    private int arranged(boolean again) {
        return again ? ++arrangements : state.arrangement();
    }

    private void draw(FigureScene scene, int arrangement) {
        draw(scene, arrangement, state.sought());
    }

    private void draw(FigureScene scene, int arrangement, int sought) {
        scenes.put(scene.mode(), scene);
        publish(new FigureState(scene, state.drawings(), state.step(), arrangement, sought));
        drawings.ask(scene);
    }

    private void accept(FigureDrawings drawn) {
        publish(
                new FigureState(
                        state.scene(),
                        drawn,
                        drawn.drawing().steps(),
                        state.arrangement(),
                        state.sought()));
    }

    private FigureState at(int step) {
        return new FigureState(
                state.scene(), state.drawings(), step, state.arrangement(), state.sought());
    }

    private void publish(FigureState next) {
        state = next;
        listeners.tell(next);
    }
}
