package rasterlab.app.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.History;
import rasterlab.app.canvas.Steps;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * The line lab without its window: which segment, which methods, which step.
 *
 * <p>Used from one thread; each change publishes a new immutable {@link LineLabState}.
 */
public final class LineLabModel implements Steps {
    private static final Segment FIRST_SEGMENT = new Segment(2, 3, 17, 9);

    private final Topic<LineRasterizer, Segment, PixelRecording> topic;
    private final LineChoice first;
    private final History<LineChoice> history = new History<>();
    private final List<Consumer<LineLabState>> listeners = new ArrayList<>();
    private LineLabState state;

    public LineLabModel(Topic<LineRasterizer, Segment, PixelRecording> topic) {
        this.topic = topic;
        first = new LineChoice(FIRST_SEGMENT, firstMethod(), "");
        state = drawn(first, 0);
    }

    public LineLabState state() {
        return state;
    }

    public List<Method<LineRasterizer>> methods() {
        return topic.methods();
    }

    public List<Hazard<Segment>> hazards() {
        return topic.hazards();
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<LineLabState> listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    /**
     * Moves an end to a pixel. Between {@link #beginDrag} and {@link #endDrag} all moves are one
     * for undo.
     */
    public void moveEnd(End end, int x, int y) {
        change(state.choice().with(end.moved(state.choice().segment(), x, y)), false);
    }

    /** Moves an end by whole pixels; stops at the ends of the int range. */
    public void nudgeEnd(End end, int dx, int dy) {
        Segment segment = state.choice().segment();
        moveEnd(end, clamped((long) end.x(segment) + dx), clamped((long) end.y(segment) + dy));
    }

    public void beginDrag() {
        history.beginDrag(state.choice());
    }

    public void endDrag() {
        history.endDrag(state.choice());
        publish(at(state.step()));
    }

    public void show(Segment segment) {
        change(state.choice().with(segment), true);
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

    public void undo() {
        history.undo().ifPresent(choice -> publish(drawn(choice, state.arrangement() + 1)));
    }

    /** Back to the first segment and method; can be undone. */
    public void reset() {
        change(first, true);
    }

    @Override
    public int first() {
        return Math.min(1, last());
    }

    @Override
    public int last() {
        return state.drawing().pixels();
    }

    @Override
    public int step() {
        return state.step();
    }

    @Override
    public void goTo(int step) {
        int next = Math.max(first(), Math.min(last(), step));
        if (next != state.step()) publish(at(next));
    }

    @Override
    public boolean turnsRound() {
        return false;
    }

    private void change(LineChoice next, boolean arrange) {
        if (next.equals(state.choice()) && !arrange) return;
        if (!next.equals(state.choice())) history.remember(state.choice());
        publish(drawn(next, state.arrangement() + (arrange ? 1 : 0)));
    }

    private LineLabState drawn(LineChoice choice, int arrangement) {
        LineDrawing drawing = LineDrawing.of(topic, choice.method(), choice.segment());
        Optional<LineDrawing> other =
                Optional.of(choice.comparison())
                        .filter(name -> !name.isEmpty())
                        .map(name -> LineDrawing.of(topic, name, choice.segment()));
        return new LineLabState(
                choice, drawing, other, drawing.pixels(), !history.isEmpty(), arrangement);
    }

    private LineLabState at(int step) {
        return new LineLabState(
                state.choice(),
                state.drawing(),
                state.other(),
                step,
                !history.isEmpty(),
                state.arrangement());
    }

    private void publish(LineLabState next) {
        state = next;
        List.copyOf(listeners).forEach(listener -> listener.accept(next));
    }

    /** The one to recommend. */
    private String firstMethod() {
        return topic.method("bresenham").name();
    }

    private static int clamped(long value) {
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, value));
    }
}
