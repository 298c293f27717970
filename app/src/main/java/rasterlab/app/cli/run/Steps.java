package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import rasterlab.app.outcome.Complaint;

/**
 * What {@code --steps} adds to an answer: the formula of the decision value and each step with it.
 *
 * <p>A walk is drained where the method runs, under {@link Watch}, never while its answer is
 * written: one that crashes must not leave half an answer behind.
 */
final class Steps {
    private static final int MOST = 1_000_000;

    private Steps() {}

    /** Writes the fields of one step. */
    @FunctionalInterface
    interface Fields<T> {
        void write(JsonGenerator json, T step) throws IOException;
    }

    /**
     * The method as one with steps.
     *
     * @throws Complaint if it has none
     */
    static <S> S of(String method, Object implementation, Class<S> stepped) {
        if (!stepped.isInstance(implementation)) throw none(method);
        return stepped.cast(implementation);
    }

    static Complaint none(String method) {
        return Complaint.badInput("--steps: method '" + method + "' has no steps");
    }

    /**
     * Passes where the steps of an answer are few enough to be kept.
     *
     * @param what is counted, in the plural
     * @throws Complaint if they are too many
     */
    static void requireAtMost(long most, String what, long count) {
        Work.requireAtMost("--steps", most, what, count);
    }

    /**
     * Adds a step to those of one answer.
     *
     * @throws Complaint if there are too many
     */
    static <T> void add(List<T> steps, T step) {
        if (steps.size() == MOST)
            throw Complaint.gaveUp(
                    "--steps: more than " + MOST + " steps, the most that one answer may have");
        steps.add(step);
    }

    /** Writes {@code decision} and {@code steps}. */
    static <T> void write(JsonGenerator json, String formula, List<T> steps, Fields<T> fields)
            throws IOException {
        json.writeStringField("decision", formula);
        json.writeFieldName("steps");
        writeArray(json, steps, fields);
    }

    /** Writes {@code steps} that decide nothing. */
    static <T> void write(JsonGenerator json, List<T> steps, Fields<T> fields) throws IOException {
        json.writeFieldName("steps");
        writeArray(json, steps, fields);
    }

    /** Writes {@code decision} and {@code steps}, a list for each thing that was walked for. */
    static <T> void writeLists(
            JsonGenerator json, String formula, List<List<T>> lists, Fields<T> fields)
            throws IOException {
        json.writeStringField("decision", formula);
        writeLists(json, lists, fields);
    }

    /** Writes {@code steps} that decide nothing, a list for each thing that was walked for. */
    static <T> void writeLists(JsonGenerator json, List<List<T>> lists, Fields<T> fields)
            throws IOException {
        json.writeArrayFieldStart("steps");
        for (List<T> steps : lists) writeArray(json, steps, fields);
        json.writeEndArray();
    }

    private static <T> void writeArray(JsonGenerator json, List<T> steps, Fields<T> fields)
            throws IOException {
        json.writeStartArray();
        for (T step : steps) {
            json.writeStartObject();
            fields.write(json, step);
            json.writeEndObject();
        }
        json.writeEndArray();
    }
}
