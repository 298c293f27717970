package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * Reads values, each of which must be what is asked for.
 *
 * <p>The input stands on the first token of a value. A value that is something else is refused by a
 * {@link InvalidInput} with the place, the value and what is allowed.
 */
public interface ValueSource {
    boolean startsObject();

    boolean startsArray();

    boolean isNull();

    /** Reads an object that has these fields and no others. */
    Given object(List<Field<?>> fields) throws IOException;

    /**
     * Reads an object that may have more fields: {@link Given#unknown} names those that are not
     * among {@code fields}.
     */
    Given openObject(List<Field<?>> fields) throws IOException;

    /**
     * Reads an array of {@code least} to {@code most} values.
     *
     * @param what the values in words, for complaints: "points"
     */
    <T> List<T> list(String what, Shape<T> item, int least, int most) throws IOException;

    /** Reads an array of {@code least} to {@code most} finite numbers. */
    double[] numbers(int least, int most) throws IOException;

    /**
     * Reads an array of points, each an array of {@code dimension} finite numbers.
     *
     * @return the coordinates, point after point
     */
    double[] points(int dimension, int least, int most) throws IOException;

    /** Reads an array of exactly {@code count} whole numbers in the range of int. */
    int[] wholes(int count) throws IOException;

    /** Reads a finite number; one too small for a double is 0 or the smallest double. */
    double number() throws IOException;

    double numberFrom(double least, double most) throws IOException;

    double numberAbove(double least, double most) throws IOException;

    int whole(int least, int most) throws IOException;

    boolean flag() throws IOException;

    String word(List<String> allowed) throws IOException;

    /**
     * Reads a text of {@code least} to {@code most} 16-bit units.
     *
     * @param expected the text in words, for complaints
     */
    String text(String expected, int least, int most) throws IOException;

    /** A complaint about the value that the input stands on, with its place. */
    InvalidInput invalid(String reason);
}
