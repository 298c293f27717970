package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class WalkTextTest {
    private static final Texts RUSSIAN = Texts.of("practice", Language.RUSSIAN);
    private static final Texts ENGLISH = Texts.of("practice", Language.ENGLISH);

    private static String told(String json, Texts texts) {
        return WalkText.told(WalkText.input(json), "clip-segment", texts);
    }

    @Test
    void fieldsHaveTheLanguagesNamesAndCommas() {
        String fields = "{\"at\": \"left\", \"start\": [-0.5, 1], \"t\": 0.25}";
        assertEquals("Сторона (at): левая; start = (−0,5; 1); t = 0,25", told(fields, RUSSIAN));
        assertEquals("Side (at): left, start = (−0.5, 1), t = 0.25", told(fields, ENGLISH));
    }

    @Test
    void aVerdictHasTheFormsNamesAndWords() {
        assertEquals(
                "ваш ответ Код (decision) = 4; Сторона (at) = верхняя; верно: start = 1",
                WalkText.named(
                        "ваш ответ decision = 4; at = top; верно: start = 1",
                        List.of("decision", "at"),
                        "clip-segment",
                        RUSSIAN));
    }

    @Test
    void aVerdictsNumbersHaveTheLanguagesComma() {
        String said = "верно: x = 0.5, y = -2, p = (4, (1, -3.25)); F(x, y), здесь 1.5";
        assertEquals(
                "верно: x = 0,5; y = −2; p = (4; (1; −3,25)); F(x, y), здесь 1,5",
                WalkText.localised(said, RUSSIAN.locale()));
        assertEquals(said.replace('-', '−'), WalkText.localised(said, ENGLISH.locale()));
    }
}
