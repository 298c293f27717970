package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonProcessingException;
import rasterlab.exercises.score.Phrase;

/** A text of people is not JSON, or more than is read. */
public final class NotJson extends Exception {
    private static final long serialVersionUID = 1;

    private final transient Phrase said;

    NotJson(JsonProcessingException cause) {
        super(cause);
        said = JsonMistake.in(cause);
    }

    /** The place and what is wrong there, such as "line 3, column 8: expected a comma or }". */
    public Phrase phrase() {
        return said;
    }

    @Override
    public String getMessage() {
        return said.toString();
    }
}
