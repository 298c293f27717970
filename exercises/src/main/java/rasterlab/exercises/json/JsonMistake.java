package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;

/** Where a text is not JSON, and why, in words that do not ask for knowledge of the parser. */
public final class JsonMistake {
    private JsonMistake() {}

    /** Such as "line 3, column 8: Duplicate field 'name'"; beyond the parser's limits no place. */
    public static String in(JsonProcessingException e) {
        JsonLocation at = e.getLocation();
        return at == null
                ? reason(e)
                : "line " + at.getLineNr() + ", column " + at.getColumnNr() + ": " + reason(e);
    }

    private static String reason(JsonProcessingException e) {
        if (e instanceof JsonEOFException)
            return "the text ends here, but something in it is not closed";
        if (e instanceof MismatchedInputException)
            return "the value ends here, but something follows it";
        // the parser's own words without "(for Array starting at [Source: …" and ", from `Class…`"
        return e.getOriginalMessage()
                .replaceFirst("(?s) \\([^(]*\\[Source.*", "")
                .replaceFirst(", from `[^`]*`", "");
    }
}
