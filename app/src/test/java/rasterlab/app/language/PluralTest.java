package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PluralTest {
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
}
