package rasterlab.app.cli.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;

class ReportTextTest {
    private static final String NAME = "steep-line";

    @ParameterizedTest(name = "a picture is not below its case''s title and name once: {0}")
    @CsvSource({"'', 'steep-line'", "a gap, 'a gap, steep-line'"})
    void picturesAreBelowTitleAndName(String title, String expected) {
        Exercise exercise = exercise(title.isEmpty() ? Map.of() : Map.of("en", title));
        List<String> lines = printed(Language.ENGLISH, exercise);
        assertEquals(expected, lines.get(lines.indexOf("  #..") - 2));
    }

    @ParameterizedTest(name = "the time is not told as: {1}")
    @CsvSource({"ENGLISH, 'Cost per pixel: 1234.50 ns'", "RUSSIAN, 'Время на пиксель: 1234,50 нс'"})
    void timeHasTheFormOfTheLanguage(Language language, String expected) {
        List<String> lines = printed(language, exercise(Map.of()));
        assertTrue(lines.contains(expected), lines.toString());
    }

    @ParameterizedTest(name = "points that hidden cases are for are not told as: {1}")
    @CsvSource({
        "ENGLISH, 'Hidden: 99 of the 100 points of the exercise are for hidden cases, which the server alone tries'",
        "RUSSIAN, 'Скрыто: 99 из 100 баллов задания даются за скрытые тесты, их выполняет только сервер'"
    })
    void pointsOfHiddenCasesAreTold(Language language, String expected) {
        List<String> lines = printed(language, exercise(Map.of()));
        assertTrue(lines.contains(expected), lines.toString());
    }

    private static List<String> printed(Language language, Exercise exercise) {
        var printed = new ByteArrayOutputStream();
        var out = new PrintStream(printed, false, StandardCharsets.UTF_8);
        new ReportText(out, Texts.of("cli", "report", language), "MyLine.java")
                .print(exercise, report());
        out.flush();
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }

    private static Exercise exercise(Map<String, String> caseTitle) {
        Exercise like = Catalogue.builtIn().named("line-bresenham");
        return new Exercise(
                like.id(),
                like.topic(),
                like.title(),
                like.statement(),
                like.pictures(),
                like.starter(),
                like.revision(),
                like.tolerance(),
                like.points(),
                List.of(
                        new Exercise.Case(
                                NAME,
                                caseTitle,
                                Exercise.Criterion.ACCURACY,
                                Disclosure.OPEN,
                                1,
                                "{}",
                                false)));
    }

    private static Report report() {
        var judged =
                new CaseReport(
                        NAME,
                        Disclosure.OPEN,
                        GradingVerdict.WRONG,
                        0,
                        1,
                        Message.NONE,
                        List.of(
                                new CasePicture(
                                        CasePicture.DIFFERENCE,
                                        new byte[0],
                                        Message.rows("#.."),
                                        Optional.empty())),
                        "");
        return new Report(
                GradingVerdict.WRONG,
                new ScorePoints(0, 0, 0, 1),
                List.of(judged),
                List.of(),
                Report.PROCESS_LIMITS,
                1234.5);
    }
}
