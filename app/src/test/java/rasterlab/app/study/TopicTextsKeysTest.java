package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** The form of what Speed &amp; accuracy says of methods, in both languages. */
class TopicTextsKeysTest {
    private static final Pattern BEGINS_ANEW =
            Pattern.compile("\\p{Lu}\\p{Ll}+ \\p{Ll}|[\\p{L} ]{1,25}: ");

    @Test
    void aMethodPromisesToBeRightWhereNoFailureIsKnown() {
        var others = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods()) {
                String failures = topicTexts(topic, Language.ENGLISH).about(method, "failures");
                if (method.promisesToBeRight() != failures.startsWith("none known"))
                    others.add(topic.name() + " " + method.name() + ": " + failures);
            }
        assertEquals(new TreeSet<>(), others);
    }

    @Test
    void whereNoMethodIsKnownToFailIsSaidInOneForm() {
        var others = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods()) {
                String english = topicTexts(topic, Language.ENGLISH).about(method, "failures");
                String failures = topicTexts(topic, Language.RUSSIAN).about(method, "failures");
                if (english.contains("none known") && !failures.contains("не найдены"))
                    others.add(failures);
            }
        assertEquals(new TreeSet<>(), others);
    }

    @Test
    @DisplayName("behind a label and its colon, words begin with a capital or end in a colon again")
    void readsOnBehindALabel() {
        var broken = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Language language : Language.values())
                for (Method<?> method : topic.methods())
                    Stream.of("invariant", "cost", "failures")
                            .map(part -> topicTexts(topic, language).about(method, part))
                            .filter(text -> BEGINS_ANEW.matcher(text).lookingAt())
                            .forEach(broken::add);
        assertEquals(new TreeSet<>(), broken);
    }

    private static TopicTexts topicTexts(Topic<?, ?, ?> topic, Language language) {
        return TopicTexts.of(topic.name(), language);
    }
}
