package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Verdict;

/** Rows and pictures of the tour, of results that are made up. */
class TourSectionsTest {
    @TempDir Path folder;

    @Test
    @DisplayName("a number of a study has a decimal point in Russian")
    void measurementIsWrittenInTheReadersLanguage() {
        var cost = new Cost(1234.567, 1200, 1300.25, Map.of());
        var error = new Deviation(0.51234567, 3, 4, 100, "");
        assertEquals(
                List.of("dda", "16", "1234,57", "1200,00–1300,25", "0,5123", "7", "неверно"),
                row(Language.RUSSIAN, cost, error, Verdict.Kind.WRONG));
        assertEquals(
                List.of("dda", "16", "1234.57", "1200.00–1300.25", "0.5123", "7", "wrong"),
                row(Language.ENGLISH, cost, error, Verdict.Kind.WRONG));
    }

    @Test
    @DisplayName("a method without a time has numbers")
    void methodThatDidNotEndHasNoNumbers() {
        assertEquals(
                List.of("dda", "16", "–", "–", "–", "–", "не останавливается"),
                row(Language.RUSSIAN, Cost.NONE, Deviation.NONE, Verdict.Kind.ENDLESS));
    }

    private static List<String> row(
            Language language, Cost cost, Deviation error, Verdict.Kind kind) {
        var measured = new Measurement("dda", "w", 16, cost, error, kind, "");
        return StudySection.row(
                measured, new StudyWords(language), Texts.of("tour", language).locale());
    }

    @Test
    @DisplayName("a graded solution has its columns in another order or language")
    void gradedSolutionIsWrittenInTheReadersLanguage() throws Exception {
        var graded =
                graded(
                        """
                        {"verdict": "runtime_error",
                         "points": {"accuracy": 40, "stability": 12, "speed": 7,
                                    "total": 59, "of": 100}}
                        """);
        assertEquals(
                List.of("Неверное решение", "исключение", "59/100", "40", "12", "7", "1,3"),
                graded.row(Texts.of("tour", Language.RUSSIAN)));
        assertEquals(
                List.of("A wrong solution", "runtime error", "59/100", "40", "12", "7", "1.3"),
                graded.row(Texts.of("tour", Language.ENGLISH)));
    }

    @Test
    @DisplayName("a picture of the first wrong case is left out, or another case's is shown")
    void firstCaseWithPicturesIsShownByAllOfThem() throws Exception {
        var graded =
                graded(
                        """
                        {"cases": [
                          {"name": "a", "title": "без картин", "pictures": []},
                          {"name": "b", "title": "крутой", "pictures": [
                            {"kind": "expected", "url": "/e", "text": "#.#", "part": null},
                            {"kind": "actual", "url": "/a", "text": "##.", "part": null},
                            {"kind": "difference", "url": "/d", "text": "#+-", "part": null},
                            {"kind": "input", "url": "/i", "text": "точка", "part": null}]},
                          {"name": "c", "title": "пологий", "pictures": [
                            {"kind": "difference", "url": "/x", "text": "+++", "part": null}]}]}
                        """);
        Files.createDirectory(folder.resolve(TourPage.PICTURES));
        var page = new TourPage(folder, Language.RUSSIAN, new PrintStream(System.out));
        GradingSection.showFirstPicture(
                page, path -> path.getBytes(StandardCharsets.UTF_8), graded);
        String html = page.html();
        int after = html.indexOf("Тест «крутой»");
        for (String kind :
                List.of(
                        "expected ожидалось",
                        "actual получено",
                        "difference разница",
                        "input input")) {
            String name = kind.split(" ")[0];
            String file = "graded-wrong-b-" + name + ".png";
            int at = html.indexOf("<figcaption>" + kind.split(" ")[1] + "<");
            assertTrue(0 < after && after < at, kind + " is not in its place: " + html);
            assertTrue(html.contains(TourPage.PICTURES + "/" + file), html);
            assertArrayEquals(
                    ("/" + name.charAt(0)).getBytes(StandardCharsets.UTF_8),
                    Files.readAllBytes(folder.resolve(TourPage.PICTURES).resolve(file)));
            after = at;
        }
        assertTrue(html.contains("<pre>#+-</pre>"), html);
        assertFalse(html.contains("пологий"), html);
    }

    private static GradingSection.GradedSolution graded(String json) throws Exception {
        JsonNode result = new ObjectMapper().readTree(json);
        return new GradingSection.GradedSolution("wrong", result, 1.26);
    }
}
