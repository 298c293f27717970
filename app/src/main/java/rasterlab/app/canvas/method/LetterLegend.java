package rasterlab.app.canvas.method;

import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Picks from what a topic says of its letters what a method's formulas need. */
final class LetterLegend {
    /** A letter of a formula, with its number, index or mark, or a name such as dx. */
    private static final Pattern LETTER =
            Pattern.compile(
                    "(?<![\\p{L}\\d_])([a-zA-Z\\p{IsGreek}][a-z]*)(?:[\\d\\p{Lm}\\p{No}]|_\\p{L})*(?!\\p{L})");

    /** Ends an explanation; a semicolon within brackets parts coordinates. */
    private static final Pattern END = Pattern.compile("; (?![^(]*\\))");

    /** English words between letters. */
    private static final Set<String> WORDS =
            Set.of("also", "and", "as", "in", "of", "the", "to", "with");

    private LetterLegend() {}

    /**
     * The explanations whose letters stand in the formulas, and those of whole words.
     *
     * @param letters such as "n and b: steps along and across; k: slope"
     */
    static String of(String letters, String formulas) {
        Set<String> used = letters(formulas);
        return Stream.of(END.split(letters))
                .filter(one -> !one.contains(": ") || isUsed(one, used))
                .collect(Collectors.joining("; "));
    }

    private static boolean isUsed(String explanation, Set<String> used) {
        Set<String> named = letters(explanation.substring(0, explanation.indexOf(": ")));
        named.removeAll(WORDS);
        named.retainAll(used);
        return !named.isEmpty();
    }

    private static Set<String> letters(String text) {
        var found = new TreeSet<String>();
        Matcher letter = LETTER.matcher(text);
        while (letter.find()) found.add(letter.group(1));
        return found;
    }
}
