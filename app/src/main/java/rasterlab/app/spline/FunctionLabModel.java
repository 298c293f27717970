package rasterlab.app.spline;

import java.util.ArrayList;
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
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.spline.function.SplineFunctionTopic;
import rasterlab.engine.spline.function.SplineProblem;
import rasterlab.engine.spline.function.SplineValues;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * The lab of functions through knots without its window.
 *
 * <p>Works like {@link CurveLabModel}; the steps are those of the method, after the last of which
 * all coefficients are known.
 */
public final class FunctionLabModel implements Kept<FunctionChoice>, Steps, AutoCloseable {
    private static final double FIRST_SHARE = 0.5;

    /** A slope's handle lies outside the knots, by this share of their width. */
    private static final double REACH = 0.08;

    private final Topic<SplineFunction, SplineProblem, SplineValues> topic;
    private final FunctionChoice first;
    private final LatestOnly<FunctionChoice, FunctionDrawings> drawings;
    private final History<Arranged<FunctionChoice>> history =
            new History<>(
                    () -> new Arranged<>(state().choice(), state().arrangement()),
                    earlier -> find(earlier.choice(), earlier.arrangement()));
    private final Listeners<FunctionLabState> listeners = new Listeners<>();
    private FunctionLabState state;

    /** Arrangements so far; one that undo brings back is no new one. */
    private int arrangements;

    private boolean arranging;

    /** A lab for a user without own programs. */
    public FunctionLabModel(Executor events, Consumer<Throwable> onFailure) {
        this(new OwnMethods(), events, onFailure);
    }

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what drawing threw, on any thread
     */
    FunctionLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        topic = own.in(new SplineFunctionTopic());
        first =
                new FunctionChoice(
                        List.of(
                                new Place(0, 0),
                                new Place(1, 0.1),
                                new Place(2, 0.1),
                                new Place(3, 0.2),
                                new Place(4, 1.8),
                                new Place(5, 2),
                                new Place(6, 2),
                                new Place(7, 1.2)),
                        SplineEnds.natural(),
                        "cubic",
                        "monotone");
        FunctionDrawings found = FunctionDrawings.of(topic, first, () -> false);
        state = new FunctionLabState(first, found, found.drawing().steps().size(), FIRST_SHARE, 0);
        drawings =
                new LatestOnly<>(
                        "spline function",
                        (choice, cancelled) -> FunctionDrawings.of(topic, choice, cancelled),
                        (choice, answer) -> events.execute(() -> accept(answer)),
                        onFailure);
    }

    public FunctionLabState state() {
        return state;
    }

    public List<Method<SplineFunction>> methods() {
        return topic.methods();
    }

    /**
     * A method of the list, or the user's own.
     *
     * @throws IllegalArgumentException naming the methods there are
     */
    Method<SplineFunction> method(String name) {
        return topic.method(name);
    }

    public List<Hazard<SplineProblem>> hazards() {
        return topic.hazards();
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<FunctionLabState> listener) {
        return listeners.add(listener);
    }

    /** Moves a knot; between {@link #beginDrag} and {@link #endDrag} all moves are one change. */
    public void move(int knot, double x, double y) {
        change(state.choice().moved(knot, new Place(x, y)), false);
    }

    /** Where the handle of an end's slope is; meant for ends with slopes and two knots or more. */
    public Place slopeHandle(boolean left) {
        List<Place> knots = state.choice().knots();
        SplineEnds ends = state.choice().ends();
        Place end = knots.get(left ? 0 : knots.size() - 1);
        double dx = left ? -reach() : reach();
        return end.plus(dx, dx * (left ? ends.left() : ends.right()));
    }

    /** Turns an end's slope so that its handle comes to that height. */
    public void moveSlope(boolean left, double y) {
        List<Place> knots = state.choice().knots();
        SplineEnds ends = state.choice().ends();
        Place end = knots.get(left ? 0 : knots.size() - 1);
        double slope = Math.rint((y - end.y()) / (left ? -reach() : reach()) * 1e4) / 1e4 + 0.0;
        chooseEnds(
                left
                        ? SplineEnds.slopes(slope, ends.right())
                        : SplineEnds.slopes(ends.left(), slope));
    }

    /** The area that the stage should show: knots, graphs and the slopes' handles. */
    public Extent everything() {
        var places = new ArrayList<>(state.choice().knots());
        if (state.drawings().choice().equals(state.choice()))
            places.addAll(state.drawing().graph());
        if (state.choice().ends().kind() == SplineEnds.Kind.SLOPES) {
            places.add(slopeHandle(true));
            places.add(slopeHandle(false));
        }
        return Extent.of(places);
    }

    private double reach() {
        double width = Extent.of(state.choice().knots()).width();
        return width > 0 ? width * REACH : 1;
    }

    public void add(double x, double y) {
        change(state.choice().added(new Place(x, y)), false);
    }

    public void remove(int knot) {
        change(state.choice().removed(knot), false);
    }

    public void beginDrag() {
        history.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        publish(at(state.step(), state.share()));
    }

    public void show(SplineProblem problem) {
        change(state.choice().withProblem(problem), true);
    }

    public void chooseEnds(SplineEnds ends) {
        change(state.choice().withEnds(ends), false);
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(state.choice().withMethod(topic.method(method).name()), false);
    }

    /**
     * @param method a method's name, "" for none
     * @throws IllegalArgumentException naming the methods there are
     */
    public void compareWith(String method) {
        if (!method.isEmpty()) topic.method(method);
        change(state.choice().withComparison(method), false);
    }

    /**
     * @param share of the way from the first to the last knot; one outside goes to the nearer end
     */
    public void readAt(double share) {
        double next = Math.max(0, Math.min(1, share));
        if (next != state.share()) publish(at(state.step(), next));
    }

    /** The choices that can be undone and redone. */
    public History<?> history() {
        return history;
    }

    /** Returns to how the lab opens; can be undone. */
    public void reset() {
        change(first, true);
        readAt(FIRST_SHARE);
    }

    @Override
    public Class<FunctionChoice> keptType() {
        return FunctionChoice.class;
    }

    @Override
    public FunctionChoice kept() {
        return state.choice();
    }

    @Override
    public void restore(FunctionChoice choice) {
        topic.method(choice.method());
        if (!choice.comparison().isEmpty()) topic.method(choice.comparison());
        find(choice, ++arrangements);
    }

    /** Waits until every choice so far is answered or dropped. Any other thread. */
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
        return state.drawing().steps().size();
    }

    @Override
    public int step() {
        return state.step();
    }

    @Override
    public void goTo(int step) {
        int next = within(step);
        if (next != state.step()) publish(at(next, state.share()));
    }

    private void change(FunctionChoice next, boolean arrange) {
        if (next.equals(state.choice()) && !arrange) return;
        if (!next.equals(state.choice())) history.remember();
        find(next, arrange ? ++arrangements : state.arrangement());
    }

    private void find(FunctionChoice choice, int arrangement) {
        arranging |= arrangement != state.arrangement();
        publish(state(choice, state.drawings(), state.step(), state.share(), arrangement));
        drawings.ask(choice);
    }

    /** A result may reach beyond the view that was arranged before it was known. */
    private void accept(FunctionDrawings found) {
        int arrangement = arranging ? ++arrangements : state.arrangement();
        arranging = false;
        publish(
                state(
                        state.choice(),
                        found,
                        found.drawing().steps().size(),
                        state.share(),
                        arrangement));
    }

    private FunctionLabState at(int step, double share) {
        return state(state.choice(), state.drawings(), step, share, state.arrangement());
    }

    private FunctionLabState state(
            FunctionChoice choice,
            FunctionDrawings found,
            int step,
            double share,
            int arrangement) {
        return new FunctionLabState(choice, found, step, share, arrangement);
    }

    private void publish(FunctionLabState next) {
        state = next;
        listeners.tell(next);
    }
}
