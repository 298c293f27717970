package rasterlab.app.study.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

class TopicNamesTest {
    private static final TopicNames RUSSIAN = TopicNames.in(Language.RUSSIAN);

    private static final Pattern RUSSIAN_WORD =
            Pattern.compile("[а-яё]{2}", Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE);

    @Test
    @DisplayName("a topic or a hazard is called in English in the Russian window")
    void everyTopicAndHazardHasARussianName() {
        var english = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all()) {
            if (!RUSSIAN_WORD.matcher(RUSSIAN.topic(topic.name())).find())
                english.add(topic.name());
            for (Hazard<?> hazard : topic.hazards())
                if (RUSSIAN.hazard(topic, hazard).equals(hazard.name()))
                    english.add(topic.name() + " " + hazard.name());
        }
        assertEquals(new TreeSet<>(), english);
    }

    @Test
    @DisplayName("two hazards of a topic, or two topics, have one name")
    void namesDiffer() {
        for (Language language : Language.values()) namesDiffer(TopicNames.in(language));
    }

    private static void namesDiffer(TopicNames called) {
        var topics = new TreeMap<String, String>();
        for (Topic<?, ?, ?> topic : Topics.all()) {
            assertEquals(null, topics.put(called.topic(topic.name()), topic.name()), topic.name());
            var hazards = new TreeMap<String, String>();
            for (Hazard<?> hazard : topic.hazards())
                assertEquals(
                        null,
                        hazards.put(called.hazard(topic, hazard), hazard.name()),
                        topic.name() + " " + hazard.name());
        }
    }

    @Test
    @DisplayName("the English window calls a hazard as commands do, with hyphens")
    void everyHazardHasAnEnglishTitle() {
        TopicNames english = TopicNames.in(Language.ENGLISH);
        var untitled = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards()) {
                String title = english.hazard(topic, hazard);
                if (title.equals(hazard.name())
                        || !title.equals(title.strip())
                        || Character.isLowerCase(title.charAt(0)) && !title.startsWith("cos"))
                    untitled.add(topic.name() + " " + title);
            }
        assertEquals(new TreeSet<>(), untitled);
    }
}
