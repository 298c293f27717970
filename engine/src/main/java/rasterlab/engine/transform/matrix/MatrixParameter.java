package rasterlab.engine.transform.matrix;

import java.io.IOException;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import rasterlab.engine.format.ValueSink;

/**
 * One parameter of a named matrix.
 *
 * @param name as in JSON
 * @param size how many numbers: 1, or 3 for a point or a direction
 * @param range which numbers are allowed
 * @param otherwise what it is where it is left out; only for one number
 */
public record MatrixParameter(
        String name, int size, ParameterRange range, OptionalDouble otherwise) {
    /** The numbers that a parameter may be. */
    public enum ParameterRange {
        ANY("a finite number", v -> true),
        DEGREES("a finite number of degrees", v -> true),
        NOT_ZERO("a finite number other than 0", v -> v != 0),
        POSITIVE("a finite number above 0", v -> v > 0),
        INSIDE_UNIT("a number above 0 and below 1", v -> v > 0 && v < 1),
        UNIT("a number from 0 to 1", v -> v >= 0 && v <= 1),
        HALF_TURN("a number of degrees above 0 and below 180", v -> v > 0 && v < 180);

        private final String text;
        private final DoublePredicate holds;

        ParameterRange(String text, DoublePredicate holds) {
            this.text = text;
            this.holds = holds;
        }

        /** The range in words, for messages. */
        public String text() {
            return text;
        }

        boolean allows(double value) {
            return Double.isFinite(value) && holds.test(value);
        }

        /** Writes what a JSON Schema says about the range of a number. */
        void writeSchema(ValueSink out) throws IOException {
            switch (this) {
                case ANY, DEGREES -> {}
                case NOT_ZERO -> {
                    out.name("not");
                    out.startObject();
                    out.whole("const", 0);
                    out.endObject();
                }
                case POSITIVE -> out.whole("exclusiveMinimum", 0);
                case INSIDE_UNIT -> {
                    out.whole("exclusiveMinimum", 0);
                    out.whole("exclusiveMaximum", 1);
                }
                case UNIT -> {
                    out.whole("minimum", 0);
                    out.whole("maximum", 1);
                }
                case HALF_TURN -> {
                    out.whole("exclusiveMinimum", 0);
                    out.whole("exclusiveMaximum", 180);
                }
            }
        }
    }

    /** The values that it may have, in words. */
    String words() {
        return size == 1 ? range.text() : "an array of " + size + " numbers";
    }

    /** Whether it is a place in space and not a direction, a number or an angle. */
    boolean place() {
        return size == 3 && !name.equals("direction") && !name.equals("up");
    }

    static MatrixParameter number(String name) {
        return number(name, ParameterRange.ANY);
    }

    static MatrixParameter number(String name, ParameterRange range) {
        return new MatrixParameter(name, 1, range, OptionalDouble.empty());
    }

    static MatrixParameter angle(String name) {
        return number(name, ParameterRange.DEGREES);
    }

    static MatrixParameter vector(String name) {
        return new MatrixParameter(name, 3, ParameterRange.ANY, OptionalDouble.empty());
    }

    MatrixParameter or(double value) {
        return new MatrixParameter(name, size, range, OptionalDouble.of(value));
    }

    /**
     * @throws IllegalArgumentException if a number is out of range
     */
    public void require(double value, int component) {
        if (range.allows(value)) return;
        String place = size == 1 ? name : name + "[" + component + "]";
        throw new IllegalArgumentException(place + " must be " + range.text() + ", got " + value);
    }
}
