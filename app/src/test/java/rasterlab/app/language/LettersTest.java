package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;

/** The letters that a topic's formulas use, and what is said of them. */
class LettersTest {
    /**
     * A Latin or Greek letter by itself: in Russian a text has no others than those of formulas.
     */
    private static final Pattern LETTER =
            Pattern.compile("(?<![\\p{L}\\d_])[A-Za-z\\p{IsGreek}](?!\\p{L})");

    /** Letters that mean the same in every formula: coordinates, π, the sign of a sum. */
    private static final Set<String> KNOWN = Set.of("x", "y", "z", "X", "Y", "Z", "π", "Σ");

    static List<String> topics() {
        return Topics.names();
    }

    @ParameterizedTest(name = "{0}: a letter of a formula is nowhere explained")
    @MethodSource("topics")
    void everyLetterOfAFormulaIsExplained(String topic) throws IOException {
        Map<String, String> russian = Translations.of(topic).texts();
        var unknown = new TreeSet<String>();
        russian.forEach(
                (key, text) -> {
                    if (key.endsWith(".formula")) unknown.addAll(letters(text));
                });
        unknown.removeAll(KNOWN);
        for (var texts : List.of(russian, Translations.english(topic))) {
            var unexplained = new TreeSet<>(unknown);
            unexplained.removeAll(letters(texts.getOrDefault("letters", "")));
            assertEquals(Set.of(), unexplained, "explain these in letters= of " + topic);
        }
    }

    private static Set<String> letters(String text) {
        var found = new TreeSet<String>();
        Matcher letter = LETTER.matcher(text);
        while (letter.find()) found.add(letter.group());
        return found;
    }
}
