package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.words.PluralForms;

class PluralTest {
    private static final Locale RUSSIAN = Language.RUSSIAN.locale();

    @ParameterizedTest(name = "{0} stands before the wrong form: {1}")
    @CsvSource({
        "1, пиксель",
        "2, пикселя",
        "4, пикселя",
        "5, пикселей",
        "0, пикселей",
        "11, пикселей",
        "12, пикселей",
        "14, пикселей",
        "21, пиксель",
        "22, пикселя",
        "111, пикселей",
        "1024, пикселя",
        "1025, пикселей",
        "0.5, пикселя",
        "1.5, пикселя",
    })
    void russianNounTakesTheFormOfItsNumber(double number, String noun) {
        Texts texts = Texts.of("study", Language.RUSSIAN);
        assertEquals(noun, texts.plural("amount.pixels", number));
    }

    @ParameterizedTest(name = "{0} stands before the wrong form: {1}")
    @CsvSource({"1, pixel", "0, pixels", "2, pixels", "21, pixels", "0.5, pixels"})
    void englishNounHasTwoForms(double number, String noun) {
        Texts texts = Texts.of("study", Language.ENGLISH);
        assertEquals(noun, texts.plural("amount.pixels", number));
    }

    @ParameterizedTest(name = "a sentence has the wrong form for {0}")
    @CsvSource({
        "1, после 1 шага на один отрезок",
        "2, после 2 шагов на один отрезок",
        "11, после 11 шагов на один отрезок",
        "21, после 21 шага на один отрезок",
    })
    void formsStandWithinSentences(int steps, String end) {
        String said = Texts.of("clip", Language.RUSSIAN).text("note.endless", "dda", steps);
        assertTrue(said.endsWith(end), said);
    }

    @Test
    @DisplayName("one pixel is called pixels")
    void countOfOneIsSingular() {
        Texts texts = Texts.of("visibility", Language.ENGLISH);
        assertEquals("1 pixel", texts.text("wrongPixels.count", 1));
        assertEquals("0 pixels", texts.text("wrongPixels.count", 0));
        assertEquals("2 pixels", texts.text("wrongPixels.count", 2));
    }

    @Test
    @DisplayName("a form that is not there leaves the braces in the sentence")
    void missingFormIsSaid() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> PluralForms.chosen("{0,plural,one#a}", new Object[] {5}, RUSSIAN));
        assertTrue(refused.getMessage().contains("many"), refused.getMessage());
        assertThrows(
                IllegalArgumentException.class,
                () -> PluralForms.chosen("{0,plural,one#a", new Object[] {1}, RUSSIAN));
    }
}
