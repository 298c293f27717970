package rasterlab.exercises.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Hint;
import rasterlab.exercises.formula.FormulaFaults;

/**
 * Hints come with an exercise, in three steps; what they cost is part of it, their words are not.
 */
class HintsTest {
    private static final int MOST_WORDS = 60;

    /** A formula or a piece of code, which is read as one word. */
    private static final Pattern SIGNS = Pattern.compile("\\$[^$]*\\$|`[^`]*`");

    private static final Pattern WORD = Pattern.compile("\\S*[\\p{L}\\p{N}]\\S*");

    static List<String> written() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .map(Exercise::id)
                .toList();
    }

    @ParameterizedTest(name = "{0} has not three short hints in both languages")
    @MethodSource("written")
    void everyWrittenExerciseHasShortHints(String id) {
        List<Hint> hints = Catalogue.builtIn().named(id).hints();
        assertEquals(Hint.STEPS, hints.size());
        for (Hint hint : hints)
            for (String language : List.of("en", "ru")) {
                String text = hint.text().get(language);
                long words = WORD.matcher(SIGNS.matcher(text).replaceAll("x")).results().count();
                assertTrue(words <= MOST_WORDS, words + " words: " + text);
                assertEquals(List.of(), FormulaFaults.in(text));
            }
        assertTrue(hints.get(0).text("ru").matches("(?s).*[а-яё].*"), hints.get(0).text("ru"));
    }

    @ParameterizedTest(name = "a hint of {0} shows a line of the model")
    @MethodSource("written")
    void noHintShowsTheModel(String id) {
        String model = Catalogue.builtIn().named(id).evidence().model().orElse("");
        String hints =
                Catalogue.builtIn().named(id).hints().stream()
                        .map(one -> one.text("en"))
                        .reduce("", String::concat);
        model.lines()
                .map(String::strip)
                .filter(line -> line.length() > 15)
                .forEach(line -> assertFalse(hints.contains(line), line));
    }

    @Test
    void hintsThatCostNothingMayLeaveOutWhatTheyCost() {
        Map<String, byte[]> files = files("circle");
        assertEquals(List.of(1, 2, 4), costs(files));
        change(files, "exercise.json", "\"hintCosts\": [1, 2, 4],", "");
        assertEquals(List.of(0, 0, 0), costs(files));
    }

    private static List<Integer> costs(Map<String, byte[]> files) {
        return Catalogue.kept("mine", files).hints().stream().map(Hint::cost).toList();
    }

    @Test
    void whatIsHandedInStaysCurrentWhenAHintIsWordedAnew() {
        Map<String, byte[]> files = files("circle");
        String before = Catalogue.kept("mine", files).revision();
        change(files, "hints.en.md", "Compute one eighth", "Take one eighth");
        Exercise after = Catalogue.kept("mine", files);
        assertTrue(after.hints().get(0).text("de").startsWith("Take one"), after.toString());
        assertEquals(before, after.revision());
        change(files, "exercise.json", "[1, 2, 4]", "[1, 2, 5]");
        assertNotEquals(before, Catalogue.kept("mine", files).revision());
    }

    private static Map<String, byte[]> files(String id) {
        return new TreeMap<>(Catalogue.builtIn().files(id));
    }

    private static void change(Map<String, byte[]> files, String name, String from, String to) {
        String text = new String(files.get(name), StandardCharsets.UTF_8);
        assertTrue(text.contains(from), text);
        files.put(name, text.replace(from, to).getBytes(StandardCharsets.UTF_8));
    }
}
