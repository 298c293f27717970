package rasterlab.app.canvas.method;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Language;

class VerdictDetailTest {
    @ParameterizedTest(name = "a difference of pixels stays in English: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "pixel (1, 2) is missing | пиксель (1; 2) пропущен",
                "pixel (1, 2) is extra | пиксель (1; 2) лишний",
                "pixel (1, 2) is missing, (3, 4) is drawn | пиксель (1; 2) пропущен, нарисован (3; 4)",
                "still going after 1016 pixels where 8 are right | не останавливается: выдано уже 1016, хотя нужно 8",
                "no result within 5 s | результата нет за 5\u00a0с",
                "a sentence of the system | a sentence of the system",
            })
    void isSaidInTheLanguageOfTheWindow(String english, String russian) {
        assertEquals(russian, VerdictDetail.translated(Language.RUSSIAN, english));
        assertEquals(english, VerdictDetail.translated(Language.ENGLISH, english));
    }

    @ParameterizedTest(name = "a hyphen stands for a minus: {0}")
    @EnumSource(Language.class)
    void coordinatesAreWrittenAsElsewhere(Language language) {
        String said = VerdictDetail.translated(language, "pixel (-1199999999, -2) is extra");
        assertTrue(said.contains("(−1199999999" + Shown.apart(language.locale()) + "−2)"), said);
    }
}
