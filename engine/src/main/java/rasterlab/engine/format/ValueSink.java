package rasterlab.engine.format;

import java.io.IOException;

/**
 * Takes values one after another: those of an array as they are, those of an object each behind its
 * name.
 */
public interface ValueSink {
    void startObject() throws IOException;

    void endObject() throws IOException;

    void startArray() throws IOException;

    void endArray() throws IOException;

    /** Writes the name of the field whose value comes next. */
    void name(String field) throws IOException;

    /** Writes a number that reads back exactly; null where there is none, as for infinity. */
    void number(double value) throws IOException;

    void whole(long value) throws IOException;

    void flag(boolean value) throws IOException;

    void text(String value) throws IOException;

    void nothing() throws IOException;

    default void number(String name, double value) throws IOException {
        name(name);
        number(value);
    }

    default void whole(String name, long value) throws IOException {
        name(name);
        whole(value);
    }

    default void flag(String name, boolean value) throws IOException {
        name(name);
        flag(value);
    }

    default void text(String name, String value) throws IOException {
        name(name);
        text(value);
    }

    /**
     * Writes a sentence for people, whose numbers are written as those of all messages are.
     *
     * @param english as the engine says it
     */
    default void sentence(String name, String english) throws IOException {
        text(name, english);
    }

    /** Writes an array of numbers. */
    default void numbers(double... values) throws IOException {
        startArray();
        for (double value : values) number(value);
        endArray();
    }

    default void numbers(String name, double... values) throws IOException {
        name(name);
        numbers(values);
    }

    /** Writes an array of whole numbers. */
    default void wholes(int... values) throws IOException {
        startArray();
        for (int value : values) whole(value);
        endArray();
    }

    default void wholes(String name, int... values) throws IOException {
        name(name);
        wholes(values);
    }

    /**
     * Writes an array of points, each an array of its coordinates.
     *
     * @param coordinates point after point
     */
    default void points(double[] coordinates, int dimension) throws IOException {
        startArray();
        for (int i = 0; i < coordinates.length; i += dimension) {
            startArray();
            for (int axis = 0; axis < dimension && i + axis < coordinates.length; axis++)
                number(coordinates[i + axis]);
            endArray();
        }
        endArray();
    }

    default void points(String name, double[] coordinates, int dimension) throws IOException {
        name(name);
        points(coordinates, dimension);
    }
}
