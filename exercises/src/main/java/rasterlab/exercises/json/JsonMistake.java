package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import rasterlab.engine.format.InvalidInput;
import rasterlab.exercises.score.Phrase;

/** Where a text is not JSON, and why, in words that do not ask for knowledge of the parser. */
final class JsonMistake {
    private static final String BEYOND = "\\((\\d+)\\) exceeds the maximum allowed \\((\\d+).*";

    /**
     * The text that should stand there, by a part of the parser's own words; the first that is in
     * them.
     */
    private static final List<Map.Entry<String, String>> EXPECTED =
            List.of(
                    Map.entry("start field name", "json.name"),
                    Map.entry("separate Object entries", "json.comma.object"),
                    Map.entry("separate Array entries", "json.comma.array"),
                    Map.entry("a colon to separate", "json.colon"),
                    Map.entry("separating root-level", "json.nothing"),
                    Map.entry("hex-digit", "json.hex"),
                    Map.entry("plus sign", "json.plus"),
                    Map.entry("digit", "json.digit"),
                    Map.entry("Leading zeroes", "json.zeros"),
                    Map.entry("comment", "json.comment"),
                    Map.entry("to be escaped", "json.breaks"),
                    Map.entry("character escape", "json.escape"),
                    Map.entry("white space", "json.control"),
                    Map.entry("token '", "json.value"),
                    Map.entry("expected a value", "json.value"));

    /** Sentences of the parser's own, with what stands in them. */
    private static final List<Map.Entry<Pattern, String>> OWN =
            List.of(
                    own("Duplicate field '(.+)'", "json.duplicate"),
                    own("Unexpected close marker '(.)': expected '(.)'", "json.close"),
                    own("Unexpected close marker '(.)': no open Object .*", "json.close.object"),
                    own("Unexpected close marker '(.)': no open Array .*", "json.close.array"),
                    own("Document nesting depth " + BEYOND, "json.deep"),
                    own("Number value length " + BEYOND, "json.long.number"),
                    own("String value length " + BEYOND, "json.long.text"),
                    own("Name length " + BEYOND, "json.long.name"));

    /** A character, or a word, that the parser quotes. */
    private static final Pattern QUOTED = Pattern.compile("(?:token|escape|\\() ?'(.+?)'(?= |:|$)");

    private static final Pattern CONTROL = Pattern.compile("CTRL-CHAR, code (\\d+)");

    private JsonMistake() {}

    /**
     * The mistake in words, such as "line 3, column 8: Duplicate field 'name'"; beyond the parser's
     * limits without a place.
     */
    static Phrase in(JsonProcessingException e) {
        JsonLocation at = e.getLocation();
        return at == null
                ? reason(e)
                : Phrase.of("json.at", at.getLineNr(), at.getColumnNr(), reason(e));
    }

    /**
     * A refusal of an input.
     *
     * @param reached where the reader stands; an exception about a limit has no place of its own
     */
    static InvalidInput invalid(JsonProcessingException e, JsonLocation reached) {
        JsonLocation at = e.getLocation() == null ? reached : e.getLocation();
        return new InvalidInput(place(at), "not JSON: " + reason(e));
    }

    static String place(JsonLocation at) {
        return place(at.getLineNr(), at.getColumnNr());
    }

    static String place(int line, int column) {
        return "line " + line + ", column " + column;
    }

    private static Phrase reason(JsonProcessingException e) {
        // the parser's own words without "(for Array starting at [Source: …" and ", from `Class…`"
        String words =
                e.getOriginalMessage()
                        .replaceFirst("(?s) \\([^(]*\\[Source.*", "")
                        .replaceFirst(", from `[^`]*`", "");
        if (e instanceof JsonEOFException || words.startsWith("Unexpected end-of-input"))
            return Phrase.of("json.open");
        if (e instanceof MismatchedInputException) return Phrase.of("json.follows");
        for (Map.Entry<String, String> each : EXPECTED)
            if (words.contains(each.getKey())) return expected(Phrase.of(each.getValue()), words);
        return own(words);
    }

    private static Phrase expected(Phrase what, String words) {
        Matcher control = CONTROL.matcher(words);
        if (control.find()) return Phrase.of("json.expected.control", what, control.group(1));
        Matcher quoted = QUOTED.matcher(words);
        return quoted.find()
                ? Phrase.of("json.expected.got", what, quoted.group(1))
                : Phrase.of("json.expected", what);
    }

    private static Map.Entry<Pattern, String> own(String pattern, String key) {
        return Map.entry(Pattern.compile(pattern), key);
    }

    private static Phrase own(String words) {
        for (Map.Entry<Pattern, String> each : OWN) {
            Matcher found = each.getKey().matcher(words);
            if (found.matches())
                return new Phrase(
                        each.getValue(),
                        IntStream.rangeClosed(1, found.groupCount())
                                .<Object>mapToObj(found::group)
                                .toList());
        }
        return Phrase.quoted(words);
    }
}
