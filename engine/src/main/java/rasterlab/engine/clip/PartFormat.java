package rasterlab.engine.clip;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.engine.format.AnswerLimitReached;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;

/** Writes the parts of segments that are left: {@code segments}, null where nothing is left. */
public final class PartFormat {
    /** The most segments of one input, and the most corners of a polygon. */
    public static final int MOST = 1_000_000;

    /** The most segments whose steps one answer may have. */
    public static final int MOST_STEPPED = 10_000;

    private PartFormat() {}

    /**
     * The field {@code segments} of an answer.
     *
     * @param width the number of coordinates of both ends
     */
    public static Field<?> segments(int width) {
        return Field.required(
                "segments", Shape.list(EitherShape.orNull(Shape.numbersOrNull(width, width))));
    }

    /** A complaint about a method that is found endless by its own steps. */
    public static AnswerLimitReached doesNotEnd(String method, int mostSteps) {
        return new AnswerLimitReached(
                method
                        + " does not end: it made more than "
                        + mostSteps
                        + " steps for one segment");
    }

    public static void requireFewStepped(int segments) {
        RecordedSteps.requireAtMost(MOST_STEPPED, "segments", segments);
    }

    public static List<double[]> rows(double[] numbers, int width) {
        return IntStream.range(0, numbers.length / width)
                .mapToObj(i -> Arrays.copyOfRange(numbers, i * width, i * width + width))
                .toList();
    }

    /** The numbers of all rows, one after the other. */
    public static double[] numbers(List<double[]> rows) {
        return rows.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    public static void write(List<Optional<double[]>> parts, ValueSink out) throws IOException {
        out.name("segments");
        out.startArray();
        for (Optional<double[]> part : parts)
            if (part.isPresent()) out.numbers(part.get());
            else out.nothing();
        out.endArray();
    }

    /** One step of a walk: what it looked at, what it decided by, what it left. */
    public record SegmentStep(String at, double decision, double[] left) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("at", at);
            out.number("decision", decision);
            out.numbers("segment", left);
        }
    }
}
