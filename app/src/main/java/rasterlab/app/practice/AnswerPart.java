package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import javax.swing.JComponent;

/** The control for one field of an answer. */
interface AnswerPart {
    /** The given answer, as JSON; empty while nothing or no number is given. */
    Optional<JsonNode> value();

    /** Shows a value that was given in the picture. */
    void set(JsonNode value);

    JComponent component();

    /** Gives the keyboard to the first of it that lacks a value, or to its first. */
    void focus();

    /** Does what a digit means to it; false where that is nothing. */
    boolean digit(int digit);
}
