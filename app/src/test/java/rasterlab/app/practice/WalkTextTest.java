package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Form;
import rasterlab.exercises.catalogue.Catalogue;

class WalkTextTest {
    private static final Texts RUSSIAN = Texts.of("practice", Language.RUSSIAN);
    private static final Texts ENGLISH = Texts.of("practice", Language.ENGLISH);

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

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
    void smallAndLargeNumbersHaveAPowerOfTen() {
        String fields = "{\"t\": 6.123233995736766E-17, \"start\": [-1.5e12, 1e-10]}";
        assertEquals("t = 6,12·10⁻¹⁷; start = (−1,5·10¹²; 1·10⁻¹⁰)", told(fields, RUSSIAN));
    }

    @ParameterizedTest(name = "the data of {0} have names that are no Russian words")
    @MethodSource("topics")
    void dataHaveRussianNames(String topic) throws Exception {
        var model =
                new PracticeModel(new PracticeExercises(), () -> 3, Runnable::run, failures::add);
        model.enter(topic);
        model.settle();
        String text = WalkText.of(model.state(), RUSSIAN);
        model.close();
        assertEquals(List.of(), failures);
        List<String> foreign =
                Pattern.compile("(?m)(?:^|[:;] )\\s*([a-z-]{3,}) =")
                        .matcher(text)
                        .results()
                        .map(found -> found.group(1))
                        .toList();
        assertEquals(List.of(), foreign, text);
    }

    static Stream<String> topics() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == Form.PREDICT)
                .map(Exercise::topic);
    }

    @Test
    void dataOfALineHaveTheirNamesAndCommas() throws Exception {
        var model =
                new PracticeModel(new PracticeExercises(), () -> 3, Runnable::run, failures::add);
        model.enter("shade-face");
        model.settle();
        String text = WalkText.of(model.state(), RUSSIAN);
        model.close();
        assertTrue(text.contains("Источник (lamp) = (2; 2; 10)"), text);
        assertTrue(text.contains("Материал (material): Фоновое (ambient) = 0,1; Диффузное"), text);
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
