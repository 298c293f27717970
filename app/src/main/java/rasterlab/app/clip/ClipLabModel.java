package rasterlab.app.clip;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.Arranged;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.clip.outcome.ClipResults;
import rasterlab.app.clip.outcome.ClipTopics;
import rasterlab.app.clip.scene.ClipGrip;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/**
 * The clipping lab without its window: what is clipped, by which methods, which step.
 *
 * <p>Clipping runs on a thread of the model's own; answers and commands all run on the thread of
 * the executor it is given. Each change publishes a new immutable {@link ClipLabState}, first with
 * the choice, then with what is left.
 */
public final class ClipLabModel implements Kept<ClipChoice>, Steps, AutoCloseable {
    private final ClipTopics topics;
    private final LatestOnly<ClipScene, ClipResults> clippings;
    private final History<Arranged<ClipChoice>> history = new History<>(this::present, this::bring);
    private final Listeners<ClipLabState> listeners = new Listeners<>();
    private ClipLabState state;

    /** Arrangements so far; one that undo brings back is no new one. */
    private int arrangements;

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what clipping threw, on any thread
     */
    public ClipLabModel(ClipTopics topics, Executor events, Consumer<Throwable> onFailure) {
        this.topics = topics;
        ClipChoice first = ClipChoice.FIRST;
        ClipResults drawn = ClipResults.of(topics, first.scene());
        state = new ClipLabState(first, drawn, resultOf(drawn), ClipGrip.end(0, 0), 0);
        clippings =
                new LatestOnly<>(
                        "clipping",
                        (scene, cancelled) -> ClipResults.of(topics, scene),
                        (scene, answer) -> events.execute(() -> accept(answer)),
                        onFailure);
    }

    public ClipLabState state() {
        return state;
    }

    List<String> methods(ClipMode mode) {
        return topics.methods(mode);
    }

    /** The chosen method. */
    Method<?> method() {
        return topics.method(state.choice().mode(), state.choice().scene().method());
    }

    public List<? extends Hazard<?>> hazards(ClipMode mode) {
        return topics.hazards(mode);
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<ClipLabState> listener) {
        return listeners.add(listener);
    }

    /** Shows another mode, with the scene it had. */
    public void chooseMode(ClipMode mode) {
        change(state.choice().in(mode), true);
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        ClipScene scene = state.choice().scene();
        edit(scene.withMethod(topics.method(scene.mode(), method).name()));
    }

    /**
     * @param method a method's name, "" for none
     * @throws IllegalArgumentException naming the methods there are
     */
    public void compareWith(String method) {
        ClipScene scene = state.choice().scene();
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
    public void show(ClipMode mode, String hazard) {
        ClipChoice choice = state.choice().in(mode);
        change(choice.with(topics.showing(choice.scene(), hazard)), true);
    }

    /**
     * Brings an input of the mode's topic.
     *
     * @throws ClassCastException if it is of another topic
     */
    public void showInput(ClipMode mode, Object input) {
        ClipChoice choice = state.choice().in(mode);
        change(choice.with(ClipTopics.showing(choice.scene(), input)), true);
    }

    /** Makes the window a rectangle, or a convex polygon. */
    public void shapeWindow(boolean upright) {
        ClipScene scene = state.choice().scene();
        if (scene instanceof SegmentScene segments) edit(segments.shaped(upright));
        else if (scene instanceof PolygonClipScene polygon) edit(polygon.shaped(upright));
    }

    /**
     * Moves a point to a place in the picture. Between {@link #beginDrag} and {@link #endDrag} all
     * moves are one for undo.
     */
    public void move(ClipGrip grip, double planeX, double planeY) {
        edit(state.choice().scene().moved(grip, new ClipPoint(planeX, planeY)));
    }

    public void beginDrag() {
        history.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        publish(at(state.step()));
    }

    /** Shows the coordinates of another point. */
    public void select(ClipGrip grip) {
        if (!grip.equals(state.selected())) publish(selecting(grip));
    }

    /** Adds a corner or a segment beside the selected one. */
    public void grow() {
        edit(state.choice().scene().grown(state.selected()));
    }

    /** Removes the selected corner or segment, unless it is needed. */
    public void shrink() {
        edit(state.choice().scene().without(state.selected()));
    }

    /** Changes something that only the view volume has. */
    void volume(UnaryOperator<VolumeScene> change) {
        edit(change.apply(state.choice().volume()));
    }

    private Arranged<ClipChoice> present() {
        return new Arranged<>(state.choice(), state.arrangement());
    }

    private void bring(Arranged<ClipChoice> earlier) {
        clip(earlier.choice(), earlier.arrangement());
    }

    /** The choices that can be undone and redone. */
    public History<?> history() {
        return history;
    }

    /** Returns to the mode's first scene and method; can be undone. */
    public void reset() {
        change(state.choice().with(state.choice().firstScene()).withDifference(false), true);
    }

    @Override
    public Class<ClipChoice> keptType() {
        return ClipChoice.class;
    }

    @Override
    public ClipChoice kept() {
        return state.choice();
    }

    @Override
    public void restore(ClipChoice choice) {
        for (ClipMode mode : ClipMode.values()) {
            ClipScene scene = choice.in(mode).scene();
            topics.method(mode, scene.method());
            if (!scene.comparison().isEmpty()) topics.method(mode, scene.comparison());
        }
        clip(choice, ++arrangements);
    }

    /** Waits until every choice so far is clipped or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        clippings.settle();
    }

    /** Ends the thread. */
    @Override
    public void close() {
        clippings.close();
    }

    @Override
    public int last() {
        return resultOf(state.results());
    }

    private static int resultOf(ClipResults results) {
        return results.clipping().steps().size() + 1;
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

    private void edit(ClipScene scene) {
        change(state.choice().with(scene), false);
    }

    private void change(ClipChoice next, boolean arrange) {
        if (next.equals(state.choice()) && !arrange) return;
        if (!next.equals(state.choice())) history.remember();
        clip(next, arrange ? ++arrangements : state.arrangement());
    }

    private void clip(ClipChoice choice, int arrangement) {
        ClipGrip selected = existing(choice.scene(), state.selected());
        publish(new ClipLabState(choice, state.results(), state.step(), selected, arrangement));
        clippings.ask(choice.scene());
    }

    /** The grip, or the first one of a scene that does not have it. */
    private static ClipGrip existing(ClipScene scene, ClipGrip grip) {
        if (scene instanceof VolumeScene volume)
            return grip.kind() == ClipGrip.ClipGripKind.END
                            && grip.index() < volume.segments().size()
                    ? grip
                    : ClipGrip.end(0, 0);
        return scene.grips().containsKey(grip) ? grip : scene.grips().keySet().iterator().next();
    }

    /** A step that was looked at is kept, if the other answer has it. */
    private void accept(ClipResults results) {
        int last = resultOf(results);
        int step = state.finished() ? last : Math.min(state.step(), last);
        publish(
                new ClipLabState(
                        state.choice(), results, step, state.selected(), state.arrangement()));
    }

    private ClipLabState at(int step) {
        return new ClipLabState(
                state.choice(), state.results(), step, state.selected(), state.arrangement());
    }

    private ClipLabState selecting(ClipGrip grip) {
        return new ClipLabState(
                state.choice(), state.results(), state.step(), grip, state.arrangement());
    }

    private void publish(ClipLabState next) {
        state = next;
        listeners.tell(next);
    }
}
