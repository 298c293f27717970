package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Properties;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;

/** Each slip of each topic is a clause for students, in both languages. */
class SlipTextsTest {
    private static final int LONGEST = 90;

    @ParameterizedTest
    @ValueSource(strings = {"messages.properties", "messages_ru.properties"})
    void everySlipHasATextAndEveryTextASlip(String file) throws IOException {
        var slips = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            names(topic).forEach(name -> slips.add("slip." + topic.name() + "." + name));
        var texts = new TreeSet<String>();
        for (String key : AllTexts.in(file).stringPropertyNames())
            if (key.startsWith("slip.")) texts.add(key);
        assertEquals(slips, texts);
        assertFalse(slips.isEmpty());
    }

    @ParameterizedTest
    @ValueSource(strings = {"messages.properties", "messages_ru.properties"})
    void aTextIsAClauseWithinAnother(String file) throws IOException {
        Properties texts = AllTexts.in(file);
        assertAll(
                texts.stringPropertyNames().stream()
                        .filter(key -> key.startsWith("slip.") || key.startsWith("change."))
                        .map(key -> () -> clause(key, texts.getProperty(key))));
    }

    private static void clause(String key, String text) {
        assertTrue(text.length() <= LONGEST, () -> key + " has " + text.length() + " characters");
        assertFalse(text.isBlank() || text.contains("{") || text.endsWith("."), key);
        assertEquals(text.strip(), text, key);
    }

    /** A slip is no mutant by another name, nor a method. */
    @Test
    void noNameIsThatOfAnotherMistake() {
        for (Topic<?, ?, ?> topic : Topics.all()) {
            var all = new TreeSet<>(names(topic).toList());
            assertEquals(names(topic).count(), all.size(), topic.name());
            topic.allMutants().forEach(one -> assertFalse(all.contains(one.name()), one.name()));
            topic.methods().forEach(one -> assertFalse(all.contains(one.name()), one.name()));
        }
    }

    private static <C> Stream<String> names(Topic<C, ?, ?> topic) {
        C right =
                topic.methods().stream()
                        .filter(Method::promisesToBeRight)
                        .findFirst()
                        .or(() -> topic.methods().stream().findFirst())
                        .orElseThrow()
                        .implementation();
        return topic.slips(right).stream().map(Slip::name);
    }
}
