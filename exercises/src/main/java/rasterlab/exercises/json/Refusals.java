package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonParser;
import java.io.IOException;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Misfit;

/** Says what is wrong with the value that a reader stands on, in the way of one kind of text. */
abstract class Refusals {
    final JsonParser parser;

    Refusals(JsonParser parser) {
        this.parser = parser;
    }

    /** Another value than the one that is allowed. */
    abstract RuntimeException other(Expected allowed) throws IOException;

    /** A value of the right kind that cannot be used. */
    abstract Misfit misfit(String reason);

    /** The array whose next value the reader stands on. */
    abstract Misfit misfitOfArray(String reason);

    /** The field that the reader stands on, which is none of these. */
    abstract RuntimeException unknown(List<Field<?>> fields);

    /** The object that was read, which lacks a field. */
    abstract RuntimeException missing(Given object, Field<?> field);

    /** The reader's place as a JSON pointer, where people are told such. */
    abstract String pointer();

    /** The length of the array that the reader stands on; -1 where it must be read to be known. */
    abstract int length();

    /**
     * Whether a whole number must be written without a point or an exponent, and a text have more
     * than blanks.
     */
    abstract boolean strict();

    /** What reads the object that the reader stands on, whose fields these are. */
    abstract StrictJson object(StrictJson reader, List<Field<?>> fields) throws IOException;
}
