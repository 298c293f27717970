package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class QueueWordsTest {
    @ParameterizedTest(name = "{0}, {1}")
    @CsvSource({
        "ENGLISH, 0, being compiled and tried",
        "ENGLISH, 1, place 1 in the queue",
        "RUSSIAN, 0, компилируется и запускается",
        "RUSSIAN, 12, место в очереди: 12"
    })
    void nobodyHasPlaceZero(Language language, int place, String said) {
        assertEquals(said, Texts.of("exercise", "messages", language).text("phase.waiting", place));
    }
}
