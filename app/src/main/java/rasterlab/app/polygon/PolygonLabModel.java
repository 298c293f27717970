package rasterlab.app.polygon;

import java.util.List;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.Arranged;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.app.polygon.outcome.PolygonResults;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * The lab of polygons without its window: which figure, which methods, which step.
 *
 * <p>Methods run on a thread of the model's own; answers and commands all run on the thread of the
 * executor it is given. Each change publishes a new immutable {@link PolygonLabState}, first with
 * the choice, then with what the methods made of it.
 */
public final class PolygonLabModel implements Kept<PolygonChoice>, Steps, AutoCloseable {
    private final PolygonTopics topics;
    private final LatestOnly<PolygonScene, PolygonResults> works;
    private final History<Arranged<PolygonChoice>> history =
            new History<>(this::present, this::bring);
    private final Listeners<PolygonLabState> listeners = new Listeners<>();
    private PolygonLabState state;

    /** Arrangements so far; one that undo brings back is no new one. */
    private int arrangements;

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what a method's work threw, on any thread
     */
    public PolygonLabModel(PolygonTopics topics, Executor events, Consumer<Throwable> onFailure) {
        this.topics = topics;
        PolygonChoice first = PolygonChoice.first();
        PolygonResults drawn = PolygonResults.of(topics, first.scene());
        state = new PolygonLabState(first, drawn, resultOf(drawn), Grip.corner(0), 0);
        works =
                new LatestOnly<>(
                        "polygon work",
                        (scene, cancelled) -> PolygonResults.of(topics, scene),
                        (scene, answer) -> events.execute(() -> accept(answer)),
                        onFailure);
    }

    public PolygonLabState state() {
        return state;
    }

    PolygonTopics topics() {
        return topics;
    }

    List<String> methods(PolygonMode mode) {
        return topics.methods(mode);
    }

    /** The chosen method. */
    Method<?> method() {
        return topics.method(state.choice().mode(), state.choice().scene().method());
    }

    public List<? extends Hazard<?>> hazards(PolygonMode mode) {
        return topics.hazards(mode);
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<PolygonLabState> listener) {
        return listeners.add(listener);
    }

    /** Shows another mode, with the scene it had. */
    public void chooseMode(PolygonMode mode) {
        change(state.choice().in(mode), true);
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        PolygonScene scene = state.choice().scene();
        edit(scene.withMethod(topics.method(scene.mode(), method).name()));
    }

    /**
     * @param method a method's name, "" for none
     * @throws IllegalArgumentException naming the methods there are
     */
    public void compareWith(String method) {
        PolygonScene scene = state.choice().scene();
        if (!method.isEmpty()) topics.method(scene.mode(), method);
        edit(scene.withComparison(method));
    }

    /** Shows two methods in one picture with what only one of them left, or side by side. */
    public void showDifference(boolean shown) {
        change(state.choice().withDifference(shown), false);
    }

    /**
     * Brings a hazard's scene, in place of that of its mode.
     *
     * @throws IllegalArgumentException if the mode's topic has no such hazard
     */
    public void show(PolygonMode mode, String hazard) {
        PolygonChoice choice = state.choice().in(mode);
        PolygonScene scene = choice.scene();
        change(choice.with(scene.with(topics.showing(scene, hazard))), true);
    }

    /**
     * Brings an input of the mode's topic.
     *
     * @throws ClassCastException if it is of another topic
     */
    public void showInput(PolygonMode mode, Object input) {
        PolygonChoice choice = state.choice().in(mode);
        PolygonScene scene = choice.scene();
        change(choice.with(scene.with(PolygonTopics.showing(scene.figure(), input))), true);
    }

    /**
     * Moves a point to a place in the picture. Between {@link #beginDrag} and {@link #endDrag} all
     * moves are one for undo.
     */
    public void move(Grip grip, double planeX, double planeY) {
        edit(figure().moved(grip, new PolygonPoint(planeX, planeY)));
    }

    public void beginDrag() {
        history.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        publish(at(state.step()));
    }

    /** Shows the coordinates of another point. */
    public void select(Grip grip) {
        if (!grip.equals(state.selected())) publish(selecting(grip));
    }

    /** Adds a corner behind the selected one, or a wall at the pen. */
    public void grow() {
        edit(figure().grown(state.selected()));
    }

    /** Removes the selected corner unless it is needed, or the wall at the pen. */
    public void shrink() {
        edit(figure().without(state.selected()));
    }

    /** Adds a corner there, moves the point there, or puts up or takes away a wall there. */
    public void click(double planeX, double planeY) {
        edit(figure().clicked(new PolygonPoint(planeX, planeY)));
    }

    /** Judges the next of the figure's points step by step. */
    public void nextPoint() {
        inside(InsideFigure::next);
    }

    /** Changes something that only a figure with points to judge has. */
    void inside(UnaryOperator<InsideFigure> change) {
        if (figure() instanceof InsideFigure old) edit(change.apply(old));
    }

    /** Changes something that only a polygon to be filled has. */
    void fill(UnaryOperator<FillFigure> change) {
        if (figure() instanceof FillFigure old) edit(change.apply(old));
    }

    /** Changes something that only a picture to be filled from a pixel has. */
    void seed(UnaryOperator<SeedFigure> change) {
        if (figure() instanceof SeedFigure old) edit(change.apply(old));
    }

    private PolygonFigure figure() {
        return state.choice().scene().figure();
    }

    private Arranged<PolygonChoice> present() {
        return new Arranged<>(state.choice(), state.arrangement());
    }

    private void bring(Arranged<PolygonChoice> earlier) {
        work(earlier.choice(), earlier.arrangement());
    }

    /** The choices that can be undone and redone. */
    public History<?> history() {
        return history;
    }

    /** Returns to the mode's first scene and method; can be undone. */
    public void reset() {
        PolygonScene first = PolygonScene.first(state.choice().mode());
        change(state.choice().with(first).withDifference(false), true);
    }

    @Override
    public Class<PolygonChoice> keptType() {
        return PolygonChoice.class;
    }

    @Override
    public PolygonChoice kept() {
        return state.choice();
    }

    @Override
    public void restore(PolygonChoice choice) {
        for (PolygonMode mode : PolygonMode.values()) {
            PolygonScene scene = choice.scenes().get(mode);
            if (scene == null || scene.mode() != mode)
                throw new IllegalArgumentException("no scene for " + mode);
            topics.method(mode, scene.method());
            if (!scene.comparison().isEmpty()) topics.method(mode, scene.comparison());
        }
        work(choice, ++arrangements);
    }

    /** Waits until every choice so far is worked on or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        works.settle();
    }

    /** Ends the thread. */
    @Override
    public void close() {
        works.close();
    }

    @Override
    public int last() {
        return resultOf(state.results());
    }

    private static int resultOf(PolygonResults results) {
        return results.outcome().steps() + 1;
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

    private void edit(PolygonFigure figure) {
        edit(state.choice().scene().with(figure));
    }

    private void edit(PolygonScene scene) {
        change(state.choice().with(scene), false);
    }

    private void change(PolygonChoice next, boolean arrange) {
        if (next.equals(state.choice()) && !arrange) return;
        if (!next.equals(state.choice())) history.remember();
        work(next, arrange ? ++arrangements : state.arrangement());
    }

    private void work(PolygonChoice choice, int arrangement) {
        Grip selected = existing(choice.scene().figure(), state.selected());
        publish(new PolygonLabState(choice, state.results(), state.step(), selected, arrangement));
        works.ask(choice.scene());
    }

    /** The grip, or the first one of a figure that does not have it. */
    private static Grip existing(PolygonFigure figure, Grip grip) {
        Set<Grip> grips = figure.grips().keySet();
        return grips.contains(grip) || grips.isEmpty() ? grip : grips.iterator().next();
    }

    /** A step that was looked at is kept, if the other answer has it. */
    private void accept(PolygonResults results) {
        int last = resultOf(results);
        int step = state.finished() ? last : Math.min(state.step(), last);
        publish(
                new PolygonLabState(
                        state.choice(), results, step, state.selected(), state.arrangement()));
    }

    private PolygonLabState at(int step) {
        return new PolygonLabState(
                state.choice(), state.results(), step, state.selected(), state.arrangement());
    }

    private PolygonLabState selecting(Grip grip) {
        return new PolygonLabState(
                state.choice(), state.results(), state.step(), grip, state.arrangement());
    }

    private void publish(PolygonLabState next) {
        state = next;
        listeners.tell(next);
    }
}
