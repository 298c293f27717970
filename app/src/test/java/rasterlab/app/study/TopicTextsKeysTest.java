package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** Which topics Speed &amp; accuracy explains in Russian. */
class TopicTextsKeysTest {
    /** Of whose methods no lab has texts. */
    private static final List<String> ENGLISH_ONLY =
            List.of(
                    "depth-order",
                    "rotate-axis",
                    "shade",
                    "shade-face",
                    "vertex-normals",
                    "view",
                    "visible-faces");

    @Test
    void methodsOfEveryTopicWithTextsAreFound() {
        var english = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods())
                if (TopicTexts.of(topic.name(), Language.RUSSIAN)
                        .filter(found -> found.texts().has(found.key(method) + ".formula"))
                        .isEmpty()) english.add(topic.name());
        assertEquals(new TreeSet<>(ENGLISH_ONLY), english);
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
