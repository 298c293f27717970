package rasterlab.exercises.predicting;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.stream.StreamSupport;

/** Compares the values of steps, and writes one for people. */
public final class StepValues {
    /** Significant digits of a number that is told. */
    private static final MathContext TOLD = new MathContext(7);

    private static final MathContext SMALL = new MathContext(3);
    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    /**
     * The number of digits from which on, and below whose inverse, numbers are told with an
     * exponent.
     */
    private static final int PLAIN_DIGITS = 10;

    private StepValues() {}

    /**
     * Whether an answer is right. Fields of it that the right one has not do not matter.
     *
     * @param tolerance the largest error of a number
     */
    static boolean same(JsonNode right, JsonNode answer, double tolerance) {
        if (right.isNumber())
            return answer.isNumber()
                    && Math.abs(right.doubleValue() - answer.doubleValue()) <= tolerance;
        if (right.isArray()) {
            if (!answer.isArray() || right.size() != answer.size()) return false;
            for (int i = 0; i < right.size(); i++)
                if (!same(right.get(i), answer.get(i), tolerance)) return false;
            return true;
        }
        if (right.isObject())
            return right.properties().stream()
                    .allMatch(
                            field ->
                                    same(field.getValue(), answer.path(field.getKey()), tolerance));
        return right.equals(answer);
    }

    /** Whether a value could be an answer: as the right one, but for its numbers and words. */
    static boolean isOfForm(JsonNode right, JsonNode answer) {
        if (right.isArray() && answer.isArray() && right.size() == answer.size()) {
            for (int i = 0; i < right.size(); i++)
                if (!isOfForm(right.get(i), answer.get(i))) return false;
            return true;
        }
        return right.isNumber() && answer.isNumber()
                || right.isTextual() && answer.isTextual()
                || right.isBoolean() && answer.isBoolean();
    }

    /** The form of an answer: the right one with 0 for each number. */
    static String form(JsonNode right) {
        if (right.isArray())
            return StreamSupport.stream(right.spliterator(), false)
                    .map(StepValues::form)
                    .collect(joining(", ", "[", "]"));
        return "0";
    }

    /** A value for people: {@code x = 3, y = 1}, {@code (0.5, 2)}, a word as it is. */
    public static String valueText(JsonNode value) {
        if (value.isObject())
            return value.properties().stream()
                    .map(field -> field.getKey() + " = " + valueText(field.getValue()))
                    .collect(joining(", "));
        if (value.isArray())
            return StreamSupport.stream(value.spliterator(), false)
                    .map(StepValues::valueText)
                    .collect(joining(", ", "(", ")"));
        return value.isNumber() ? number(value) : value.asText();
    }

    private static String number(JsonNode value) {
        BigDecimal rounded = value.decimalValue().round(TOLD).stripTrailingZeros();
        if (rounded.signum() == 0) return "0";
        int exponent = rounded.precision() - rounded.scale() - 1;
        if (Math.abs(exponent) < PLAIN_DIGITS) return rounded.toPlainString();
        // A number so small is mostly rounding, whose later digits say nothing.
        BigDecimal few = exponent < 0 ? rounded.round(SMALL).stripTrailingZeros() : rounded;
        int power = few.precision() - few.scale() - 1;
        return few.movePointLeft(power).toPlainString() + "·10" + raised(power);
    }

    private static String raised(int exponent) {
        return String.valueOf(exponent)
                .chars()
                .mapToObj(c -> c == '-' ? "⁻" : RAISED.substring(c - '0', c - '0' + 1))
                .collect(joining());
    }
}
