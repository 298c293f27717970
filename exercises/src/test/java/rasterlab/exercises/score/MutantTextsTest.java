package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.Topics;

/** Each mutant of each topic is a clause for students, in both languages. */
class MutantTextsTest {
    private static final String PREFIX = "mutant.";
    private static final int LONGEST = 90;

    @ParameterizedTest
    @ValueSource(strings = {"messages.properties", "messages_ru.properties"})
    void everyMutantHasATextAndEveryTextAMutant(String file) throws IOException {
        TreeSet<String> mutants = mutants();
        TreeSet<String> texts = keys(AllTexts.in(file));
        assertEquals(Set.of(), without(texts, mutants), "mutants without a text");
        assertEquals(Set.of(), without(mutants, texts), "texts without a mutant");
    }

    @ParameterizedTest
    @ValueSource(strings = {"messages.properties", "messages_ru.properties"})
    void aTextIsAClauseWithinAnother(String file) throws IOException {
        Properties texts = AllTexts.in(file);
        assertAll(keys(texts).stream().map(key -> () -> clause(key, texts.getProperty(key))));
    }

    private static void clause(String key, String text) {
        assertTrue(text.length() <= LONGEST, () -> key + " has " + text.length() + " characters");
        assertFalse(text.isBlank() || text.contains("{"), key);
        assertEquals(text.strip(), text, key);
        assertFalse(text.endsWith("."), () -> key + " is a sentence");
        boolean sentence = Character.isUpperCase(text.charAt(0)) && !isName(text.split(" ")[0]);
        assertFalse(sentence, () -> key + " begins as a sentence does");
    }

    /** A letter of a formula, a shape such as B-spline, or a matrix in capitals. */
    private static boolean isName(String word) {
        return word.length() == 1 || word.charAt(1) == '-' || Character.isUpperCase(word.charAt(1));
    }

    /** Two mistakes of a topic are not told by the same words within one language. */
    @ParameterizedTest
    @ValueSource(strings = {"messages.properties", "messages_ru.properties"})
    void noTwoMutantsOfATopicAreSaidAlike(String file) throws IOException {
        Properties texts = AllTexts.in(file);
        for (var topic : Topics.all()) {
            var said =
                    keys(texts).stream()
                            .filter(key -> key.startsWith(PREFIX + topic.name() + "."))
                            .map(texts::getProperty)
                            .toList();
            assertEquals(said.size(), said.stream().distinct().count(), () -> topic.name() + said);
        }
    }

    @Test
    void aClauseStandsInItsFrameInTheReadersLanguage() {
        Phrase said =
                Phrase.of("known-mistake", Phrase.of("mutant.point-in-triangle.side-is-outside"));
        assertEquals("the same comes out if a point on a side counts as outside", said.in("en"));
        assertEquals("то же получается, если точка на стороне считается внешней", said.in("ru"));
    }

    private static TreeSet<String> without(Set<String> some, TreeSet<String> all) {
        var rest = new TreeSet<>(all);
        rest.removeAll(some);
        return rest;
    }

    private static TreeSet<String> mutants() {
        return Topics.all().stream()
                .flatMap(
                        topic ->
                                topic.allMutants().stream()
                                        .map(one -> PREFIX + topic.name() + "." + one.name()))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static TreeSet<String> keys(Properties texts) {
        Stream<String> all = texts.stringPropertyNames().stream();
        return all.filter(key -> key.startsWith(PREFIX))
                .collect(Collectors.toCollection(TreeSet::new));
    }
}
