package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import rasterlab.app.canvas.LatestOnly;
import rasterlab.app.canvas.Listeners;
import rasterlab.exercises.predicting.Question;

/**
 * The mode "which is next?" of one lab, without its window: which questions, which answers. The
 * lab's own model knows nothing of it and stays as it is.
 *
 * <p>Questions are drawn on a thread of the model's own; answers and commands all run on the thread
 * of the executor it is given.
 */
public final class PracticeModel implements AutoCloseable {
    /** A seed of practice is short, so that it is easily told. */
    public static final long SEEDS = 1_000_000;

    private final LatestOnly<PracticeState, PracticeSheet> drawings;
    private final Listeners<PracticeState> listeners = new Listeners<>();
    private final LongSupplier seeds;
    private PracticeState state = PracticeState.LEFT;

    /**
     * @param seeds gives the seed of new data, in [0, {@link #SEEDS})
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what drawing threw, on any thread
     */
    public PracticeModel(
            PracticeExercises exercises,
            LongSupplier seeds,
            Executor events,
            Consumer<Throwable> onFailure) {
        this.seeds = seeds;
        drawings =
                new LatestOnly<>(
                        "questions",
                        (asked, cancelled) ->
                                exercises.sheet(asked.topic().orElseThrow(), asked.seed()),
                        (asked, sheet) -> events.execute(() -> accept(asked, sheet)),
                        onFailure);
    }

    PracticeState state() {
        return state;
    }

    /** Tells the listener each new state from now on; the answer ends that. */
    Runnable listen(Consumer<PracticeState> listener) {
        return listeners.add(listener);
    }

    /** Begins to ask for steps of a topic's method, on fresh data. */
    public void enter(String topic) {
        draw(PracticeState.LEFT.drawing(topic, seeds.getAsLong()));
    }

    /** Asks on fresh data; what was answered still counts. */
    void newData() {
        dataOf(seeds.getAsLong());
    }

    /** Asks on the data of a seed; what was answered still counts. */
    void dataOf(long seed) {
        state.topic().ifPresent(topic -> draw(state.drawing(topic, seed)));
    }

    private void draw(PracticeState next) {
        publish(next);
        drawings.ask(next);
    }

    private void accept(PracticeState asked, PracticeSheet sheet) {
        if (asked.equals(state)) publish(state.drawn(sheet));
    }

    /**
     * Judges an answer to the present question and goes on from the right one.
     *
     * @param tolerance the largest error of a number, if more than the exercise's own
     */
    void answer(JsonNode answer, double tolerance) {
        if (!state.isAsking()) return;
        Question question = state.question();
        publish(
                state.answered(
                        new Answered(question, answer, question.isRight(answer, tolerance))));
    }

    /** Goes on where the walk rests; behind the last question to fresh data. */
    void next() {
        if (!state.resting()) return;
        if (state.isThrough()) newData();
        else publish(state.next());
    }

    /** Back to the lab. */
    void leave() {
        publish(PracticeState.LEFT);
    }

    private void publish(PracticeState next) {
        state = next;
        listeners.tell(next);
    }

    /** Waits until the questions are drawn or dropped. Any other thread. */
    void settle() throws InterruptedException {
        drawings.settle();
    }

    /** Ends the thread. */
    @Override
    public void close() {
        drawings.close();
    }
}
