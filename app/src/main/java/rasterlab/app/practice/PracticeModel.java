package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.SheetText;

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
    private Optional<GradedSheet> graded = Optional.empty();
    private Optional<InvalidEntry> refusal = Optional.empty();

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

    /** Asks the questions of a sheet that is handed in. */
    public void answer(GradedSheet sheet) {
        graded = Optional.of(sheet);
        var asked = new PracticeSheet(sheet.exercise(), sheet.begun().sheet());
        publish(PracticeState.of(asked, new Graded(sheet.begun().answers())));
    }

    /** Goes to an earlier or a later question of a sheet that is handed in. */
    void turn(int by) {
        if (state.graded().isPresent()) publish(state.at(state.at() + by));
    }

    /** Hands the sheet in as it is, and goes back to the lab. */
    void handIn() {
        if (state.graded().isEmpty()) return;
        String sheet = written();
        GradedSheet handed = graded.orElseThrow();
        publish(PracticeState.LEFT);
        handed.handIn().accept(sheet);
    }

    /** The sheet with the answers so far. */
    private String written() {
        PracticeSheet sheet = state.asked().orElseThrow();
        List<JsonNode> answers = state.graded().orElseThrow().answers();
        return SheetText.written(
                sheet.exercise().id(), sheet.sheet(), one -> answers.get(one.number() - 1));
    }

    /** Asks on fresh data; what was answered still counts. */
    void newData() {
        dataOf(seeds.getAsLong());
    }

    /** Asks on the data of a seed; what was answered still counts. */
    void dataOf(long seed) {
        if (state.graded().isPresent()) return;
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
     * Judges an answer to the present question and goes on from the right one; in a sheet that is
     * handed in the answer stays.
     *
     * @param tolerance the largest error of a number, if more than the exercise's own; none in a
     *     sheet that is handed in
     */
    void answer(JsonNode answer, double tolerance) {
        if (!state.isAsking()) return;
        if (state.graded().isPresent()) {
            publish(state.noted(answer));
            graded.orElseThrow().keep().accept(written());
            return;
        }
        Question question = state.question();
        publish(
                state.answered(
                        new AnsweredQuestion(
                                question, answer, question.isRight(answer, tolerance))));
    }

    /** Goes on where the walk rests; behind the last question to fresh data. */
    void next() {
        if (!state.resting()) return;
        if (state.isThrough() && state.graded().isEmpty()) newData();
        else publish(state.next());
    }

    /** Returns to the lab, or to the exercise whose sheet was answered. */
    void leave() {
        boolean answered = state.graded().isPresent();
        publish(PracticeState.LEFT);
        if (answered) graded.orElseThrow().back().run();
    }

    /** Returns to the lab, which is about to show something else; a sheet keeps its answers. */
    public void giveWay() {
        if (state.topic().isPresent()) publish(PracticeState.LEFT);
    }

    /** Keeps why the last thing that was typed is not taken, until the state changes. */
    void refuse(InvalidEntry why) {
        refusal = Optional.of(why);
    }

    /** Why the last thing that was typed was not taken; empty where it was. */
    Optional<InvalidEntry> refusal() {
        return refusal;
    }

    private void publish(PracticeState next) {
        refusal = Optional.empty();
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
