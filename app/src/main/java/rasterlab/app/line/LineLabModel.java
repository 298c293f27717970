package rasterlab.app.line;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.line.figure.FigureLabModel;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Plotted;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * The line lab without its window: which segment, which methods, which step.
 *
 * <p>Drawing runs on a thread of the model's own; answers and commands all run on the thread of the
 * executor it is given. Each change publishes a new immutable {@link LineLabState}, first with the
 * choice, then with what it draws.
 */
public final class LineLabModel implements Kept<LineChoice>, Steps, AutoCloseable {
    private static final Segment FIRST_SEGMENT = new Segment(2, 3, 17, 9);

    private final Topic<LineRasterizer, Segment, PixelRecording> topic;
    private final LineChoice first;
    private final LatestOnly<Question, LineDrawings> drawings;
    private final History<Remembered> history = new History<>(this::present, this::bring);
    private final Listeners<LineLabState> listeners = new Listeners<>();
    private final FigureLabModel figures;
    private final Listeners<LineMode> modeListeners = new Listeners<>();

    /** The mode as it was chosen; among the figures undo may have gone on to another. */
    private LineMode mode = LineMode.SEGMENT;

    private Optional<TrialSegment> tried = Optional.empty();
    private LineLabState state;

    /** Arrangements so far; one that undo brought back is no new one. */
    private int arrangements;

    /** A lab for a user without own programs. */
    public LineLabModel(
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            Executor events,
            Consumer<Throwable> onFailure) {
        this(topic, new OwnMethods(), events, onFailure);
    }

    /**
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what drawing threw, on any thread
     */
    public LineLabModel(
            Topic<LineRasterizer, Segment, PixelRecording> lines,
            OwnMethods own,
            Executor events,
            Consumer<Throwable> onFailure) {
        this.topic = own.in(lines);
        figures = new FigureLabModel(own, events, onFailure);
        first = new LineChoice(FIRST_SEGMENT, firstMethod(), "");
        LineDrawings drawn = LineDrawings.of(topic, first);
        state = new LineLabState(first, drawn, drawn.drawing().pixels(), 0);
        drawings =
                new LatestOnly<>(
                        "line",
                        (asked, cancelled) ->
                                asked.shown().next(topic, asked.choice(), asked.tried(), cancelled),
                        (asked, answer) -> events.execute(() -> accept(answer)),
                        onFailure);
    }

    /**
     * @param shown what is drawn already and may serve again
     */
    private record Question(LineChoice choice, Optional<TrialSegment> tried, LineDrawings shown) {}

    /** The state that undo restores; another arrangement shows the whole segment again. */
    private record Remembered(LineChoice choice, Optional<TrialSegment> tried, int arrangement) {}

    public LineLabState state() {
        return state;
    }

    /** The figures that the lab draws besides segments. */
    public FigureLabModel figures() {
        return figures;
    }

    /** The figure that the lab draws now. */
    public LineMode mode() {
        return mode == LineMode.SEGMENT ? mode : figures.state().scene().mode();
    }

    /** Shows another mode, with what it had; undo goes back from it among figures only. */
    public void chooseMode(LineMode next) {
        if (next != LineMode.SEGMENT) figures.chooseMode(next);
        mode = next;
        modeListeners.tell(next);
    }

    /** The mode as it is kept between runs, beside the segment and the {@link #figures}. */
    public Kept<LineMode> keptMode() {
        return new Kept<>() {
            @Override
            public Class<LineMode> keptType() {
                return LineMode.class;
            }

            @Override
            public LineMode kept() {
                return mode();
            }

            @Override
            public void restore(LineMode choice) {
                chooseMode(choice);
            }
        };
    }

    /**
     * The pixels that {@link #showTried} showed last, as they are kept between runs, beside the
     * segment.
     */
    public Kept<SavedTrial> keptTried() {
        return new Kept<>() {
            @Override
            public Class<SavedTrial> keptType() {
                return SavedTrial.class;
            }

            @Override
            public SavedTrial kept() {
                return SavedTrial.of(tried);
            }

            @Override
            public void restore(SavedTrial kept) {
                if (!kept.right().isEmpty()) topic.method(kept.right());
                tried = kept.tried();
                draw(state.choice(), state.arrangement());
            }
        };
    }

    /** Tells the listener each mode from now on; the answer ends that. */
    Runnable listenToMode(Consumer<LineMode> listener) {
        return modeListeners.add(listener);
    }

    public List<Method<LineRasterizer>> methods() {
        return topic.methods();
    }

    /**
     * A method of the list, or the user's own.
     *
     * @throws IllegalArgumentException naming the methods there are
     */
    Method<LineRasterizer> method(String name) {
        return topic.method(name);
    }

    public List<Hazard<Segment>> hazards() {
        return topic.hazards();
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    public Runnable listen(Consumer<LineLabState> listener) {
        return listeners.add(listener);
    }

    /**
     * Moves an end to a pixel. Between {@link #beginDrag} and {@link #endDrag} all moves are one
     * for undo.
     */
    public void moveEnd(End end, int x, int y) {
        change(state.choice().with(end.moved(state.choice().segment(), x, y)));
    }

    /** Moves an end by whole pixels; stops at the ends of the int range. */
    public void nudgeEnd(End end, int dx, int dy) {
        Segment segment = state.choice().segment();
        moveEnd(end, clamped((long) end.x(segment) + dx), clamped((long) end.y(segment) + dy));
    }

    public void beginDrag() {
        history.beginDrag();
    }

    public void endDrag() {
        history.endDrag();
        publish(at(state.step()));
    }

    public void show(Segment segment) {
        arrange(state.choice().with(segment), Optional.empty());
    }

    /**
     * Shows a segment and beside it, as long as nothing else is compared, what a program of the
     * user's did with it; one change for undo.
     *
     * @param method that draws it rightly; "" for the chosen one
     * @param drawn what the program plotted; empty where that was right or is not known
     * @throws IllegalArgumentException naming the methods there are
     */
    public void showTried(Segment segment, String method, Optional<Plotted> drawn) {
        String right = method.isEmpty() ? state.choice().method() : topic.method(method).name();
        chooseMode(LineMode.SEGMENT);
        var program = new TrialSegment(segment, right, drawn);
        arrange(new LineChoice(segment, right, ""), Optional.of(program));
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(state.choice().withMethod(topic.method(method).name()));
    }

    /**
     * @param method a method's name, "" for none
     * @throws IllegalArgumentException naming the methods there are
     */
    public void compareWith(String method) {
        if (!method.isEmpty()) topic.method(method);
        change(state.choice().withComparison(method));
    }

    /** The choices that can be undone and redone. */
    public History<?> history() {
        return history;
    }

    /** Returns to the first segment and method; can be undone. */
    public void reset() {
        arrange(first, Optional.empty());
    }

    @Override
    public Class<LineChoice> keptType() {
        return LineChoice.class;
    }

    @Override
    public LineChoice kept() {
        return state.choice();
    }

    @Override
    public void restore(LineChoice choice) {
        topic.method(choice.method());
        if (!choice.comparison().isEmpty()) topic.method(choice.comparison());
        draw(choice, ++arrangements);
    }

    /** Waits until every choice so far is drawn or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        drawings.settle();
    }

    /** Ends the threads. */
    @Override
    public void close() {
        figures.close();
        drawings.close();
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
        int next = within(step);
        if (next != state.step()) publish(at(next));
    }

    private Remembered present() {
        return new Remembered(state.choice(), tried, state.arrangement());
    }

    private void change(LineChoice next) {
        if (next.equals(state.choice())) return;
        history.remember();
        draw(next, state.arrangement());
    }

    /** Changes the segment so that the stage is to show the whole of it. */
    private void arrange(LineChoice next, Optional<TrialSegment> program) {
        if (!next.equals(state.choice()) || !program.equals(tried)) history.remember();
        tried = program;
        draw(next, ++arrangements);
    }

    private void bring(Remembered earlier) {
        tried = earlier.tried();
        draw(earlier.choice(), earlier.arrangement());
    }

    private void draw(LineChoice choice, int arrangement) {
        publish(state(choice, state.drawings(), state.step(), arrangement));
        drawings.ask(new Question(choice, tried, state.drawings()));
    }

    private void accept(LineDrawings drawn) {
        publish(state(state.choice(), drawn, drawn.drawing().pixels(), state.arrangement()));
    }

    private LineLabState at(int step) {
        return state(state.choice(), state.drawings(), step, state.arrangement());
    }

    private LineLabState state(LineChoice choice, LineDrawings drawn, int step, int arrangement) {
        return new LineLabState(choice, drawn, step, arrangement);
    }

    private void publish(LineLabState next) {
        state = next;
        listeners.tell(next);
    }

    /** The one to recommend. */
    private String firstMethod() {
        return topic.method("bresenham").name();
    }

    private static int clamped(long value) {
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, value));
    }
}
