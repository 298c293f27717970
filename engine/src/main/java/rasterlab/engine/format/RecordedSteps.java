package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * The recorded walk of a method: the formula of the value it decides by, and each step with it.
 *
 * <p>A walk is drained where the method runs, never while its answer is written: one that crashes
 * must not leave half an answer behind.
 */
public final class RecordedSteps implements Written {
    /** The most steps that one answer may have. */
    public static final int MOST = 1_000_000;

    private final String formula;
    private final List<? extends Written> steps;
    private final List<? extends List<? extends Written>> lists;

    private RecordedSteps(
            String formula,
            List<? extends Written> steps,
            List<? extends List<? extends Written>> lists) {
        this.formula = formula;
        this.steps = steps;
        this.lists = lists;
    }

    /** Steps that decide by a value. */
    public static RecordedSteps deciding(String formula, List<? extends Written> steps) {
        return new RecordedSteps(formula, steps, null);
    }

    /** Steps that decide nothing. */
    public static RecordedSteps plain(List<? extends Written> steps) {
        return new RecordedSteps(null, steps, null);
    }

    /** A list of steps that decide by a value for each thing that was walked for. */
    public static RecordedSteps decidingLists(
            String formula, List<? extends List<? extends Written>> lists) {
        return new RecordedSteps(formula, null, lists);
    }

    /** A list of steps that decide nothing for each thing that was walked for. */
    public static RecordedSteps plainLists(List<? extends List<? extends Written>> lists) {
        return new RecordedSteps(null, null, lists);
    }

    /**
     * Adds a step to those of one answer.
     *
     * @throws AnswerLimitReached if there are too many
     */
    public static <T> void add(List<T> steps, T step) {
        if (steps.size() == MOST)
            throw new AnswerLimitReached(
                    "--steps: more than " + MOST + " steps, the most that one answer may have");
        steps.add(step);
    }

    /**
     * Passes where the steps of an answer are few enough to be kept.
     *
     * @param what is counted, in the plural
     * @throws InvalidInput if they are too many
     */
    public static void requireAtMost(long most, String what, long count) {
        requireAtMost("--steps", most, what, count);
    }

    /**
     * Passes where there is little enough to do for it to end within seconds.
     *
     * @param place in the input, or the option, that makes it too much
     * @param what is counted, in the plural
     * @throws InvalidInput if it is too much
     */
    public static void requireAtMost(String place, long most, String what, long count) {
        if (count > most)
            throw new InvalidInput(place, "at most " + most + " " + what + ", got " + count);
    }

    @Override
    public void write(ValueSink out) throws IOException {
        if (formula != null) out.text("decision", formula);
        out.name("steps");
        if (steps != null) write(out, steps);
        else {
            out.startArray();
            for (List<? extends Written> each : lists) write(out, each);
            out.endArray();
        }
    }

    private static void write(ValueSink out, List<? extends Written> steps) throws IOException {
        out.startArray();
        for (Written step : steps) {
            out.startObject();
            step.write(out);
            out.endObject();
        }
        out.endArray();
    }
}
