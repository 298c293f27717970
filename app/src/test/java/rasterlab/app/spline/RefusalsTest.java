package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.spline.CurveTopic;
import rasterlab.engine.spline.SplineFunctionTopic;
import rasterlab.engine.study.Topic;

class RefusalsTest {
    private static final Texts RUSSIAN = Texts.of("spline", "topic", Language.RUSSIAN);

    @Test
    void everyRefusalOfAHazardIsTranslated() {
        var messages = new ArrayList<String>();
        collect(new CurveTopic(), messages);
        collect(new SplineFunctionTopic(), messages);
        assertTrue(messages.size() > 20, messages.toString());
        for (String message : messages) {
            String said = Refusals.said(RUSSIAN, message);
            assertTrue(said.matches(".*[а-я]{4}.*"), message);
            assertFalse(said.contains("must"), said);
        }
    }

    private static <C, I, O> void collect(Topic<C, I, O> topic, List<String> messages) {
        for (var hazard : topic.hazards())
            for (var method : topic.methods())
                try {
                    topic.record(method.implementation(), hazard.input(), 20_000);
                } catch (IllegalArgumentException refusal) {
                    messages.add(refusal.getMessage());
                }
    }

    @Test
    void numbersOfTheRefusalStay() {
        assertEquals(
                "x[3] должно быть больше, чем x[2] = 1.0; здесь 0.5",
                Refusals.said(RUSSIAN, "x[3] must be above x[2] = 1.0, got 0.5"));
    }

    @Test
    void unknownMessageStaysAsItIs() {
        assertEquals("something else", Refusals.said(RUSSIAN, "something else"));
        Texts english = Texts.of("spline", "topic", Language.ENGLISH);
        assertEquals("x: needs …", Refusals.said(english, "x: needs …"));
    }
}
