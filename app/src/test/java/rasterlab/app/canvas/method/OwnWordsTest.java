package rasterlab.app.canvas.method;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import javax.swing.text.BadLocationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.Topics;

class OwnWordsTest {
    static List<String> topics() {
        return Topics.names();
    }

    @ParameterizedTest
    @MethodSource("topics")
    void aCommandNamesARightMethodWhereNothingStandsBesideTheProgram(String topic) {
        for (String beside : List.of("", OwnMethods.NAME)) {
            String known = OwnWords.known(OwnMethods.NAME, beside, topic);
            assertFalse(Topics.named(topic).method(known).faulty(), known);
        }
    }

    @ParameterizedTest
    @MethodSource("topics")
    void aCommandNamesTheMethodBesideTheProgram(String topic) {
        assertEquals("other", OwnWords.known(OwnMethods.NAME, "other", topic));
    }

    @Test
    void aProgramThatWasStoppedIsNotSaidToRefuse() {
        String stopped = "your program did not answer within 2.0 s and was stopped";
        assertEquals(
                "Your program did not answer within 2 s and was stopped",
                OwnWords.reason(OwnMethods.NAME, stopped, Language.ENGLISH));
        assertEquals(
                "Ваша программа не ответила за 2\u00a0с и была остановлена",
                OwnWords.reason(OwnMethods.NAME, stopped, Language.RUSSIAN));
        assertEquals("no answer", OwnWords.without(OwnMethods.NAME, "refused", Language.ENGLISH));
        assertEquals("refused", OwnWords.without("dda", "refused", Language.ENGLISH));
    }

    @Test
    void aProgramThatRefusesInWordsOfItsOwnIsSaidTo() {
        assertEquals(
                "Your program refuses: radius -1",
                OwnWords.reason(OwnMethods.NAME, "radius -1", Language.ENGLISH));
        assertEquals("radius -1", OwnWords.reason("midpoint", "radius -1", Language.ENGLISH));
    }

    @Test
    void theExplanationHasNoHeadingOfARefusalForTheProgram() throws Exception {
        var said = new ArrayList<String>();
        EventQueue.invokeAndWait(
                () -> {
                    var about = new AboutText("about", Language.ENGLISH);
                    Texts texts = Texts.ofTopic("line", Language.ENGLISH);
                    about.show(texts, OwnMethods.NAME, "", "It was stopped");
                    said.add(plain(about));
                });
        assertTrue(said.get(0).startsWith("No answer: It was stopped"), said.get(0));
    }

    private static String plain(AboutText about) {
        try {
            return about.getDocument().getText(0, about.getDocument().getLength()).strip();
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
    }

    @ParameterizedTest
    @MethodSource("topics")
    void aCommandNamesAnyOtherMethodAsItIs(String topic) {
        assertEquals("this", OwnWords.known("this", "other", topic));
    }
}
