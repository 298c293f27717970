package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * Says which values are allowed, and what they become.
 *
 * @param <T> what it becomes
 */
public interface Shape<T> {
    /** The most points of one input. */
    int MOST_POINTS = 10_000_000;

    /**
     * Reads the value that the input stands on.
     *
     * @throws InvalidInput if it is none of this shape
     */
    T read(ValueSource in) throws IOException;

    /** Writes a value so that {@link #read} makes it again. */
    void write(T value, ValueSink out) throws IOException;

    /** Writes the shape as a schema of JSON Schema, 2020-12. */
    void schema(ValueSink out) throws IOException;

    /** A finite number. */
    static Shape<Double> number() {
        return new NumberShape(-Double.MAX_VALUE, Double.MAX_VALUE, NumberShape.IncludedEnds.ANY);
    }

    /** A number from {@code least} to {@code most}. */
    static Shape<Double> number(double least, double most) {
        return new NumberShape(least, most, NumberShape.IncludedEnds.CLOSED);
    }

    /** A number above {@code least}, up to {@code most}. */
    static Shape<Double> numberAbove(double least, double most) {
        return new NumberShape(least, most, NumberShape.IncludedEnds.ABOVE);
    }

    /** A whole number from {@code least} to {@code most}. */
    static Shape<Integer> whole(int least, int most) {
        return new WholeShape(least, most);
    }

    /** One of the words. */
    static Shape<String> word(List<String> words) {
        return new WordShape(words);
    }

    /**
     * A text of {@code least} to {@code most} 16-bit units.
     *
     * @param what the text in words, for complaints: "a text of one character"
     */
    static Shape<String> text(String what, int least, int most) {
        return new TextShape(what, least, most);
    }

    /** A text of any length. */
    static Shape<String> text() {
        return new TextShape("a text", 0, Integer.MAX_VALUE);
    }

    /** The shape of a flag: true or false. */
    static Shape<Boolean> flag() {
        return new FlagShape();
    }

    /** {@code least} to {@code most} finite numbers. */
    static Shape<double[]> numbers(int least, int most) {
        return new NumbersShape(least, most);
    }

    /** {@code least} to {@code most} numbers of an answer, each null where there is none. */
    static Shape<List<Double>> numbersOrNull(int least, int most) {
        return new ListShape<>("numbers", EitherShape.orNull(number()), least, most);
    }

    /** {@code least} to {@code most} points of {@code dimension} coordinates, one after another. */
    static Shape<double[]> points(int dimension, int least, int most) {
        return new PointsShape(dimension, least, most);
    }

    /** {@code count} whole numbers in the range of int. */
    static Shape<int[]> wholes(int count) {
        return new IntArrayShape(count);
    }

    /**
     * A list of {@code least} to {@code most} values.
     *
     * @param what the values in words, for complaints: "rows"
     */
    static <T> Shape<List<T>> list(String what, Shape<T> item, int least, int most) {
        return new ListShape<>(what, item, least, most);
    }

    /** A list of any length. */
    static <T> Shape<List<T>> list(Shape<T> item) {
        return new ListShape<>("values", item, 0, Integer.MAX_VALUE);
    }

    /**
     * A value of a shape, of which a schema says more: what the whole input refuses by itself.
     *
     * @param told of the values that are not refused
     */
    static <T> Shape<T> described(Shape<T> shape, Shape<?> told) {
        return new DescribedShape<>(shape, told);
    }

    /**
     * An array of which a schema says more: which values each of its places may have.
     *
     * @param places the shapes of all of them in their order
     */
    static <T> Shape<T> describedByPlace(Shape<T> array, Shape<?>... places) {
        return new PlacesShape<>(array, List.of(places));
    }

    /** A shape such as {@code numbers(count, count)}, of which a schema says the range of each. */
    static Shape<double[]> boundedNumbers(int count, double least, double most) {
        return described(numbers(count, count), list("numbers", number(least, most), count, count));
    }

    /** An object with these fields. */
    static Shape<Given> object(Field<?>... fields) {
        return new ObjectShape(List.of(fields));
    }
}
