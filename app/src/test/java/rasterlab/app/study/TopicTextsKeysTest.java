package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** Which topics Speed &amp; accuracy explains in Russian. */
class TopicTextsKeysTest {
    private static final Pattern BEGINS_ANEW =
            Pattern.compile("\\p{Lu}\\p{Ll}+ \\p{Ll}|[\\p{L} ]{1,25}: ");

    @Test
    void methodsOfEveryTopicHaveTexts() {
        var english = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods())
                if (!russian(topic).texts().has(russian(topic).key(method) + ".formula"))
                    english.add(topic.name() + " " + method.name());
        assertEquals(new TreeSet<>(), english);
    }

    @Test
    void hazardsOfEveryTopicHaveTexts() {
        var english = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards())
                if (russian(topic).hazard(hazard).equals(hazard.description()))
                    english.add(topic.name() + " " + hazard.name());
        assertEquals(new TreeSet<>(), english);
    }

    @Test
    void whereNoMethodIsKnownToFailIsSaidInOneForm() {
        var others = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods()) {
                var said = russian(topic);
                String failures = said.texts().text(said.key(method) + ".failures");
                if (method.about().failures().contains("none known")
                        && !failures.contains("не найдены")) others.add(failures);
            }
        assertEquals(new TreeSet<>(), others);
    }

    @Test
    @DisplayName("behind a label and its colon, words begin with a capital or end in a colon again")
    void readsOnBehindALabel() {
        var broken = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Method<?> method : topic.methods()) {
                var said = russian(topic);
                String key = said.key(method);
                Method.About about = method.about();
                Stream.of(
                                about.invariant(),
                                about.cost(),
                                about.failures(),
                                said.texts().text(key + ".invariant"),
                                said.texts().text(key + ".cost"),
                                said.texts().text(key + ".failures"))
                        .filter(text -> BEGINS_ANEW.matcher(text).lookingAt())
                        .forEach(broken::add);
            }
        assertEquals(new TreeSet<>(), broken);
    }

    private static TopicTexts russian(Topic<?, ?, ?> topic) {
        return TopicTexts.of(LabRooms.card(topic.name()), Language.RUSSIAN);
    }
}
