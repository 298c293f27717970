package rasterlab.exercises.predicting;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.document.OwnJson;

/** Steps are told with the names, words and signs of a language. */
class StepTextTest {
    private static final Locale RUSSIAN = Locale.forLanguageTag("ru");
    private static final StepText CLIP_RU = new StepText("clip-segment", RUSSIAN);
    private static final StepText CLIP_EN = new StepText("clip-segment", Locale.ENGLISH);

    @Test
    void fieldsHaveTheLanguagesNamesAndCommas() throws Exception {
        JsonNode fields =
                OwnJson.MAPPER.readTree("{\"at\": \"left\", \"start\": [-0.5, 1], \"t\": 0.25}");
        assertEquals(
                "Сторона (at): левая; start = (−0,5; 1); t = 0,25", CLIP_RU.fieldsText(fields));
        assertEquals("Side (at): left, start = (−0.5, 1), t = 0.25", CLIP_EN.fieldsText(fields));
    }

    @Test
    void smallAndLargeNumbersHaveAPowerOfTen() throws Exception {
        JsonNode fields =
                OwnJson.MAPPER.readTree(
                        "{\"t\": 6.123233995736766E-17, \"start\": [-1.5e12, 1e-10]}");
        assertEquals("t = 6,12·10⁻¹⁷; start = (−1,5·10¹²; 1·10⁻¹⁰)", CLIP_RU.fieldsText(fields));
    }

    @Test
    void aVerdictHasTheFormsNamesAndWords() {
        assertEquals(
                "ваш ответ Код (decision) = 4; Сторона (at) = верхняя; верно: start = 1",
                CLIP_RU.named(
                        "ваш ответ decision = 4; at = top; верно: start = 1",
                        List.of("decision", "at")));
    }

    @Test
    void aVerdictsNumbersHaveTheLanguagesComma() {
        String said = "верно: x = 0.5, y = -2, p = (4, (1, -3.25)); F(x, y), здесь 1.5";
        assertEquals(
                "верно: x = 0,5; y = −2; p = (4; (1; −3,25)); F(x, y), здесь 1,5",
                CLIP_RU.localised(said));
        assertEquals(said.replace('-', '−'), CLIP_EN.localised(said));
    }

    @ParameterizedTest(name = "a step of {0} has an English name in a Russian report")
    @MethodSource("exercises")
    void stepsHaveRussianNames(String id) {
        Exercise exercise = Catalogue.builtIn().named(id);
        List<String> foreign = new ArrayList<>();
        for (Question one :
                Sheet.of(exercise.topic(), exercise.predicting().orElseThrow(), 5).questions()) {
            if (one.reason().filter(JsonNode::isTextual).isEmpty()) continue;
            String name = one.reason().get().asText();
            boolean isNamed = name.matches("[A-Za-z]{3,}.*|.* [A-Za-z]{3,}.*");
            if (isNamed && one.why().in("ru").contains(name)) foreign.add(name);
        }
        assertEquals(List.of(), foreign);
    }

    static Stream<String> exercises() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == TaskKind.PREDICT)
                .map(Exercise::id);
    }
}
