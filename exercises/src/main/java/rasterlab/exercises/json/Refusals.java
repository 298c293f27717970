package rasterlab.exercises.json;

import java.io.IOException;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;

/** Says what is wrong with the value that a reader stands on, in the way of one kind of text. */
interface Refusals {
    /** The refusal of a value of another kind than the one that is allowed. */
    RuntimeException other(Expected allowed) throws IOException;

    /** The refusal of a value of the right kind that cannot be used. */
    InvalidInput invalid(String reason);

    /** The refusal of the array whose next value the reader stands on. */
    InvalidInput invalidArray(String reason);

    /** The field that the reader stands on, which is none of these. */
    RuntimeException unknown(List<Field<?>> fields);

    /** The object that was read, which lacks a field. */
    RuntimeException missing(Given object, Field<?> field);

    /** The reader's place as a JSON pointer, where people are told such. */
    String pointer();

    /** The length of the array that the reader stands on; -1 where it must be read to be known. */
    int length();

    /**
     * Whether a whole number must be written without a point or an exponent, and a text have more
     * than blanks.
     */
    boolean strict();

    /** Returns the reader of the object that the given one stands on, whose fields these are. */
    StrictJson object(StrictJson reader, List<Field<?>> fields) throws IOException;
}
