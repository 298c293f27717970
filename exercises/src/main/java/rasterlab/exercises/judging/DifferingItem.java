package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.engine.raster.Pixel;

/**
 * The first item in which an answer differs from the right one; neither pixel nor index where that
 * is the answer as a whole.
 *
 * @param pixel where pixels are asked for
 * @param index in the list that is asked for, from 0
 */
public record DifferingItem(Optional<Pixel> pixel, OptionalInt index) {
    private static final Pattern IN_A_LIST =
            Pattern.compile("(inside|visible|pixels|segments)\\[(\\d+)].*");

    /** The answer as a whole. */
    static final DifferingItem WHOLE = new DifferingItem(Optional.empty(), OptionalInt.empty());

    public static DifferingItem at(Pixel pixel) {
        return new DifferingItem(Optional.of(pixel), OptionalInt.empty());
    }

    /**
     * The item at a place of an answer's JSON; empty where no method decides on such.
     *
     * @param right the right answer
     * @param actual the one that differs there
     */
    public static Optional<DifferingItem> at(String place, JsonNode right, JsonNode actual) {
        Matcher parts = IN_A_LIST.matcher(place);
        if (!parts.matches()) return Optional.empty();
        int index = Integer.parseInt(parts.group(2));
        return parts.group(1).equals("pixels")
                ? firstInRows(right.path("pixels").path(index), actual.path("pixels").path(index))
                        .map(DifferingItem::at)
                : Optional.of(new DifferingItem(Optional.empty(), OptionalInt.of(index)));
    }

    /** The first pixel, row by row, that one of the two answers lacks. */
    private static Optional<Pixel> firstInRows(JsonNode right, JsonNode actual) {
        if (!right.isArray())
            return actual.isArray() ? Optional.of(pixel(actual)) : Optional.empty();
        Pixel expected = pixel(right);
        if (!actual.isArray()) return Optional.of(expected);
        Pixel drawn = pixel(actual);
        boolean later =
                drawn.y() > expected.y() || drawn.y() == expected.y() && drawn.x() >= expected.x();
        return Optional.of(later ? expected : drawn);
    }

    private static Pixel pixel(JsonNode numbers) {
        return new Pixel(numbers.path(0).asInt(), numbers.path(1).asInt());
    }
}
