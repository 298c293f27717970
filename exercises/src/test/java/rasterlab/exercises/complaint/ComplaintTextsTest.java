package rasterlab.exercises.complaint;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A complaint is found by its words, and its counts have the form that goes with them. */
class ComplaintTextsTest {
    private static final Locale RUSSIAN = Locale.forLanguageTag("ru");

    @ParameterizedTest(name = "one value is told as several, or a form is not known again: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "/f: only 1 value; expected 4 or 8 | /f: значений только 1; здесь допустимо: 4 или 8",
                "/f: only 0 values; expected 4 or 8 | /f: значений только 0; здесь допустимо: 4 или 8",
                "/f: more than 1 value; expected 4 or 8 | /f: значений больше чем 1; здесь допустимо: 4 или 8"
            })
    void eitherFormIsKnownAndTheRightOneSaid(String english, String russian) {
        assertEquals(russian, ComplaintTexts.translated(RUSSIAN, english));
        assertEquals(english, ComplaintTexts.saidToTypist(Locale.ENGLISH, english));
    }
}
