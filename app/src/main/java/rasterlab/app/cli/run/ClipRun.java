package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.study.LimitReached;

/** What the clipping topics' inputs and answers share. */
final class ClipRun {
    /** The most segments of one input, and the most corners of a polygon. */
    static final int MOST = 1_000_000;

    /** The most segments whose steps one answer may have. */
    static final int MOST_STEPPED = 10_000;

    private ClipRun() {}

    /**
     * Waits for a method that may be found endless by its own steps.
     *
     * @param mostSteps for one segment
     * @throws Complaint as {@link Watch#call}, or that the method does not end
     */
    static <T> T watched(Watch watch, String method, int mostSteps, Supplier<T> work) {
        return watch.call(
                method,
                () -> {
                    try {
                        return work.get();
                    } catch (LimitReached endless) {
                        throw doesNotEnd(method, mostSteps);
                    }
                });
    }

    private static Complaint doesNotEnd(String method, int mostSteps) {
        return Complaint.gaveUp(
                method
                        + " does not end: it made more than "
                        + mostSteps
                        + " steps for one segment");
    }

    static void requireFewStepped(int segments) {
        Steps.requireAtMost(MOST_STEPPED, "segments", segments);
    }

    static List<double[]> rows(double[] numbers, int width) {
        return IntStream.range(0, numbers.length / width)
                .mapToObj(i -> Arrays.copyOfRange(numbers, i * width, i * width + width))
                .toList();
    }

    /** Writes {@code segments}, null where nothing is left. */
    static void writeParts(JsonGenerator json, List<Optional<double[]>> parts) throws IOException {
        json.writeArrayFieldStart("segments");
        for (Optional<double[]> part : parts)
            if (part.isPresent()) JsonNumbers.write(json, part.get());
            else json.writeNull();
        json.writeEndArray();
    }

    /** One step of a walk: what it looked at, what it decided by, what it left. */
    record Step(String at, double decision, double[] left) {
        void write(JsonGenerator json) throws IOException {
            json.writeStringField("at", at);
            JsonNumbers.writeField(json, "decision", decision);
            json.writeFieldName("segment");
            JsonNumbers.write(json, left);
        }
    }
}
