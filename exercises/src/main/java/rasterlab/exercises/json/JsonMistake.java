package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Where a text is not JSON, and why, in words that do not ask for knowledge of the parser. */
public final class JsonMistake {
    private static final String VALUE =
            "a value: a text in double quotes, a number, {…}, […], true, false or null";

    /** What should stand there, by a part of the parser's own words; the first that is in them. */
    private static final List<Map.Entry<String, String>> EXPECTED =
            List.of(
                    Map.entry("start field name", "a field's name in double quotes"),
                    Map.entry("separate Object entries", "a comma or }"),
                    Map.entry("separate Array entries", "a comma or ]"),
                    Map.entry("a colon to separate", "a colon after the field's name"),
                    Map.entry("separating root-level", "nothing more"),
                    Map.entry("hex-digit", "four hexadecimal digits after \\u"),
                    Map.entry("plus sign", "a number without a plus sign"),
                    Map.entry("digit", "a digit"),
                    Map.entry("Leading zeroes", "a number without superfluous zeros"),
                    Map.entry("comment", "a value, no comment"),
                    Map.entry(
                            "to be escaped",
                            "no line break or other control character within a text"),
                    Map.entry("character escape", "one of \" \\ / b f n r t u after a backslash"),
                    Map.entry("white space", "no control character"),
                    Map.entry("token '", VALUE),
                    Map.entry("expected a value", VALUE));

    /** A character, or a word, that the parser quotes. */
    private static final Pattern QUOTED = Pattern.compile("(?:token|escape|\\() ?'(.+?)'(?= |:|$)");

    private static final Pattern CONTROL = Pattern.compile("CTRL-CHAR, code (\\d+)");

    private JsonMistake() {}

    /** Such as "line 3, column 8: Duplicate field 'name'"; beyond the parser's limits no place. */
    public static String in(JsonProcessingException e) {
        JsonLocation at = e.getLocation();
        return at == null
                ? reason(e)
                : "line " + at.getLineNr() + ", column " + at.getColumnNr() + ": " + reason(e);
    }

    private static String reason(JsonProcessingException e) {
        // the parser's own words without "(for Array starting at [Source: …" and ", from `Class…`"
        String words =
                e.getOriginalMessage()
                        .replaceFirst("(?s) \\([^(]*\\[Source.*", "")
                        .replaceFirst(", from `[^`]*`", "");
        if (e instanceof JsonEOFException || words.startsWith("Unexpected end-of-input"))
            return "the text ends here, but something in it is not closed";
        if (e instanceof MismatchedInputException)
            return "the value ends here, but something follows it";
        for (Map.Entry<String, String> each : EXPECTED)
            if (words.contains(each.getKey())) return "expected " + each.getValue() + got(words);
        return words;
    }

    private static String got(String words) {
        Matcher control = CONTROL.matcher(words);
        if (control.find()) return ", got the control character " + control.group(1);
        Matcher quoted = QUOTED.matcher(words);
        return quoted.find() ? ", got '" + quoted.group(1) + "'" : "";
    }
}
