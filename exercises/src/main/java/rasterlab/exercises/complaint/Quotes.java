package rasterlab.exercises.complaint;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The quotation marks of each language, in which names and what was typed stand. */
final class Quotes {
    /**
     * Matches a text in a language's quotation marks, whatever was typed within them; or in
     * straight quotes, of which an apostrophe in or behind a word is none.
     */
    static final Pattern QUOTED =
            Pattern.compile("«[^»]*»|“[^”]*”|(?<![\\p{L}\\p{N}])'([^'\\n]*)'(?![\\p{L}\\p{N}])");

    private Quotes() {}

    /** The sentence with marks of the language for straight ones. */
    static String of(Locale language, String sentence) {
        String marked = language.getLanguage().equals("en") ? "“%s”" : "«%s»";
        return QUOTED.matcher(sentence)
                .replaceAll(
                        found ->
                                Matcher.quoteReplacement(
                                        found.group(1) == null
                                                ? found.group()
                                                : marked.formatted(found.group(1))));
    }
}
