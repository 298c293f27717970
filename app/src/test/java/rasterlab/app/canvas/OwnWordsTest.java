package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
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

    @ParameterizedTest
    @MethodSource("topics")
    void aCommandNamesAnyOtherMethodAsItIs(String topic) {
        assertEquals("this", OwnWords.known("this", "other", topic));
    }
}
