package rasterlab.exercises.published;

import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Writes words that were read from JSON as people read them: with the sign of a minus. */
public final class ShownWords {
    /** Matches a quotation, or a hyphen in front of a number. */
    private static final Pattern HYPHEN =
            Pattern.compile("\"[^\"]*\"|“[^”]*”|«[^»]*»|(?<![\\p{L}\\d])-(?=[\\d∞])");

    private ShownWords() {}

    /** These words; what is quoted, such as a student's own text, stays as it is. */
    public static String of(String inJson) {
        return HYPHEN.matcher(inJson).replaceAll(ShownWords::shown);
    }

    private static String shown(MatchResult found) {
        return found.group().equals("-") ? "−" : Matcher.quoteReplacement(found.group());
    }
}
