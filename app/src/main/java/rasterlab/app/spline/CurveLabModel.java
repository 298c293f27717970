package rasterlab.app.spline;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.Arranged;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.spline.curve.CurveAt;
import rasterlab.app.spline.curve.CurvePlanning;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * The lab of curves without its window: which points, which method, which t.
 *
 * <p>Drawing runs on a thread of the model's own; answers and commands all run on the thread of the
 * executor it is given. Each change publishes a new immutable {@link CurveLabState}, first with the
 * choice, then with what it draws. The steps are the points that the method sends: going to one
 * goes to its t.
 */
public final class CurveLabModel implements Kept<CurveChoice>, Steps, AutoCloseable {
    private static final double FIRST_T = 0.4;

    /** The flatness at first, in pixels. */
    static final double FIRST_FLATNESS = 5;

    private final Topic<CurveTracer, CurveTask, Polyline> topic;
    private final OwnMethods own;
    private final CurveChoice first;
    private final LatestOnly<CurveChoice, CurveDrawings> drawings;
    private final History<Arranged<CurveChoice>> history =
            new History<>(
                    () -> new Arranged<>(state().choice(), state().arrangement()),
                    earlier -> draw(earlier.choice(), earlier.arrangement()));
    private final Listeners<CurveLabState> listeners = new Listeners<>();
    private CurveLabState state;

    /** Arrangements so far; one that undo brings back is no new one. */
    private int arrangements;

    /** A lab for a user without own programs. */
    public CurveLabModel(Executor events, Consumer<Throwable> onFailure) {
        this(new OwnMethods(), events, onFailure);
    }

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what drawing threw, on any thread
     */
    CurveLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        this.own = own;
        topic = own.in(new CurveTopic());
        first =
                new CurveChoice(
                        CurveForm.BEZIER,
                        FirstCurves.points(CurveForm.BEZIER),
                        CurveJoining.C1,
                        Sampling.flat(FIRST_FLATNESS),
                        "adaptive",
                        "",
                        new CurveOverlays(true, true, false),
                        CurvePlanning.FIRST);
        state = state(first, CurveDrawings.of(topic, first, () -> false), FIRST_T, 0);
        drawings =
                new LatestOnly<>(
                        "curve",
                        (choice, cancelled) -> CurveDrawings.of(topic, choice, cancelled),
                        (choice, answer) -> events.execute(() -> accept(answer)),
                        onFailure);
    }

    public CurveLabState state() {
        return state;
    }

    public List<Method<CurveTracer>> methods() {
        return topic.methods();
    }

    /**
     * A method of the list, or the user's own.
     *
     * @throws IllegalArgumentException naming the methods there are
     */
    Method<CurveTracer> method(String name) {
        return topic.method(name);
    }

    public List<Hazard<CurveTask>> hazards() {
        return topic.hazards();
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<CurveLabState> listener) {
        return listeners.add(listener);
    }

    /** Moves a handle; between {@link #beginDrag} and {@link #endDrag} all moves are one change. */
    public void move(int handle, double x, double y) {
        change(state.choice().moved(handle, new Place(x, y)), false);
    }

    /** Adds a point or a piece, where the form has room for it. */
    public void add(double x, double y) {
        change(state.choice().added(new Place(x, y)), false);
    }

    /** Removes a point, or a piece with it, where the form can do without it. */
    public void remove(int handle) {
        change(state.choice().removed(handle), false);
    }

    public void beginDrag() {
        history.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        publish(state(state.choice(), state.drawings(), state.t(), state.arrangement()));
    }

    public void show(CurveTask task) {
        change(state.choice().withTask(task), true);
    }

    public void chooseForm(CurveForm form) {
        change(state.choice().withForm(form), true);
    }

    public void chooseJoining(CurveJoining joining) {
        change(state.choice().withJoining(joining), false);
    }

    public void sample(Sampling sampling) {
        change(state.choice().withSampling(sampling), false);
    }

    /** Asks for what the user's program was written for, of the curve that is shown if it can. */
    void askWhatOwnAnswers() {
        own.of(topic.name())
                .map(program -> new OwnCurve(program.exercise()))
                .ifPresent(
                        asked -> {
                            CurveForm form = asked.form(state.choice().form());
                            if (form != state.choice().form()) chooseForm(form);
                            sample(asked.sampling(state.choice().sampling()));
                        });
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(state.choice().byHand(topic.method(method).name()), false);
    }

    /** Lets the plan choose the method, and for how many drawings; or no more. */
    public void plan(CurvePlanning planning) {
        change(state.choice().withPlanning(planning), false);
    }

    /**
     * @param method a method's name, "" for none
     * @throws IllegalArgumentException naming the methods there are
     */
    public void compareWith(String method) {
        if (!method.isEmpty()) topic.method(method);
        change(state.choice().withComparison(method), false);
    }

    public void overlay(CurveOverlays overlays) {
        change(state.choice().withOverlays(overlays), false);
    }

    /**
     * @param t over all curves; one outside [0, 1] goes to the nearer end
     */
    public void goToT(double t) {
        double next = Math.max(0, Math.min(1, t));
        if (next != state.t())
            publish(state(state.choice(), state.drawings(), next, state.arrangement()));
    }

    /** The choices that can be undone and redone. */
    public History<?> history() {
        return history;
    }

    /** Returns to how the lab opens; can be undone. */
    public void reset() {
        change(first, true);
        goToT(FIRST_T);
    }

    @Override
    public Class<CurveChoice> keptType() {
        return CurveChoice.class;
    }

    @Override
    public CurveChoice kept() {
        return state.choice();
    }

    @Override
    public void restore(CurveChoice choice) {
        topic.method(choice.method());
        if (!choice.comparison().isEmpty()) topic.method(choice.comparison());
        choice.curves();
        draw(choice, ++arrangements);
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
    public int last() {
        return state.drawing().segments();
    }

    @Override
    public int step() {
        return state.step();
    }

    @Override
    public void goTo(int step) {
        List<CurveDrawing.Corner> points = state.drawing().points();
        if (!points.isEmpty()) goToT(points.get(Math.max(0, Math.min(last(), step))).t());
    }

    private void change(CurveChoice next, boolean arrange) {
        if (next.equals(state.choice()) && !arrange) return;
        if (!next.equals(state.choice())) history.remember();
        draw(next, arrange ? ++arrangements : state.arrangement());
    }

    private void draw(CurveChoice choice, int arrangement) {
        publish(state(choice, state.drawings(), state.t(), arrangement));
        drawings.ask(choice);
    }

    /** The method that the plan chose becomes the chosen one, which is no change of its own. */
    private void accept(CurveDrawings drawn) {
        CurveChoice choice = state.choice();
        boolean planned = choice.planning().on() && choice.equals(drawn.choice());
        publish(
                state(
                        planned ? choice.withMethod(drawn.drawing().method()) : choice,
                        drawn,
                        state.t(),
                        state.arrangement()));
    }

    private CurveLabState state(
            CurveChoice choice, CurveDrawings drawn, double t, int arrangement) {
        return new CurveLabState(
                choice,
                drawn,
                t,
                CurveAt.of(drawn.choice().curves(), t),
                reached(drawn.drawing().points(), t),
                arrangement);
    }

    /** Index of the last point whose t is not beyond {@code t}; 0 where there is none. */
    private static int reached(List<CurveDrawing.Corner> points, double t) {
        int low = 0;
        int high = points.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) / 2;
            if (points.get(middle).t() <= t) low = middle;
            else high = middle - 1;
        }
        return low;
    }

    private void publish(CurveLabState next) {
        state = next;
        listeners.tell(next);
    }
}
