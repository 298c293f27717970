package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** Which topics Speed &amp; accuracy explains in Russian. */
class TopicTextsKeysTest {
    @Test
    void methodsOfEveryTopicHaveTexts() {
        var english = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods())
                if (TopicTexts.of(topic.name(), Language.RUSSIAN)
                        .filter(found -> found.texts().has(found.key(method) + ".formula"))
                        .isEmpty()) english.add(topic.name() + " " + method.name());
        assertEquals(new TreeSet<>(), english);
    }

    @Test
    void hazardsOfEveryTopicHaveTexts() {
        var english = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards())
                if (TopicTexts.of(topic.name(), Language.RUSSIAN)
                        .flatMap(found -> found.hazard(hazard))
                        .isEmpty()) english.add(topic.name() + " " + hazard.name());
        assertEquals(new TreeSet<>(), english);
    }

    @Test
    void whereNoMethodIsKnownToFailIsSaidInOneForm() {
        var others = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods()) {
                var said = TopicTexts.of(topic.name(), Language.RUSSIAN).orElseThrow();
                String failures = said.texts().text(said.key(method) + ".failures");
                if (method.about().failures().contains("none known")
                        && !failures.contains("ошибок не известно")) others.add(failures);
            }
        assertEquals(new TreeSet<>(), others);
    }

    @Test
    void partComesBeforeNamesInALabOfSeveralTopics() {
        var seed = TopicTexts.of("fill", Language.RUSSIAN).orElseThrow();
        Topic<?, ?, ?> fill =
                Topics.all().stream().filter(t -> t.name().equals("fill")).findAny().orElseThrow();
        assertEquals(
                List.of(), fill.hazards().stream().filter(h -> seed.hazard(h).isEmpty()).toList());
    }
}
