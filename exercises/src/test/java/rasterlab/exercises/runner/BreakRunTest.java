package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.Exercise.Breaking;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** Inputs are paid for what they break, or their fault is told. */
@Tag("slow")
class BreakRunTest {
    private static final String CLIP = "break-clip-segment";
    private static final String CUT_AT_THE_RIGHT =
            "{\"window\": [0, 0, 10, 10], \"segments\": [[5, 5, 15, 5]]}";
    private static final String CUT_AT_THE_LEFT =
            "{\"window\": [0, 0, 10, 10], \"segments\": [[-5, 5, 5, 5]]}";

    private static Judge judge;

    @BeforeAll
    static void start() {
        judge = Judge.start(OtherSettings.onceInNoBox());
    }

    @AfterAll
    static void end() {
        judge.close();
    }

    private static Report report(String exercise, String sent) throws InterruptedException {
        return report(judge, exercise, sent);
    }

    private static Report report(Judge judge, String exercise, String sent)
            throws InterruptedException {
        return judge.grade(
                Catalogue.builtIn().named(exercise), sent, CaseSelection.open(), done -> {});
    }

    private static CaseReport of(Report report, String name) {
        return report.cases().stream()
                .filter(one -> one.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void anInputPaysForTheMethodsThatFailOnIt() throws InterruptedException {
        Report report = report(CLIP, CUT_AT_THE_LEFT);
        CaseReport left = of(report, "left-does-not-cut");
        assertEquals(GradingVerdict.OK, left.verdict());
        assertEquals(left.of(), left.points());
        assertTrue(left.message().contains("-5"), left.message());
        assertTrue(left.scene().contains("clip-segment"), left.scene());
        CaseReport top = of(report, "top-does-not-cut");
        assertEquals(GradingVerdict.WRONG, top.verdict());
        assertEquals(0, top.points());
        int sum = report.cases().stream().mapToInt(CaseReport::points).sum();
        assertEquals(sum, report.points().total());
        assertEquals(100, report.points().of());
    }

    @Test
    void oneOfSeveralInputsIsEnough() throws InterruptedException {
        Report report = report(CLIP, "[" + CUT_AT_THE_RIGHT + ", " + CUT_AT_THE_LEFT + "]");
        CaseReport left = of(report, "left-does-not-cut");
        assertEquals(GradingVerdict.OK, left.verdict());
        assertTrue(left.message().contains("with input 2"), left.message());
    }

    @Test
    void whatGoesOnWithoutEndIsBroken() throws InterruptedException {
        Report report = report(CLIP, "{\"window\": [0, 0, 10, 10], \"segments\": [[0, 2, 20, 8]]}");
        CaseReport nested = of(report, "cohen-sutherland-nested-textbook");
        assertEquals("it goes on without end", nested.message());
        assertEquals(nested.of(), nested.points());
        CaseReport after = of(report, "point-segment-dropped");
        assertEquals(GradingVerdict.WRONG, after.verdict(), "the others are tried all the same");
    }

    @Test
    void aSmallerInputPaysMore() throws InterruptedException {
        String many = CUT_AT_THE_LEFT.replace("]]", "]" + ", [1, 1, 2, 2]".repeat(60) + "]");
        int small = of(report(CLIP, CUT_AT_THE_LEFT), Breaking.SIZE).points();
        int large = of(report(CLIP, many), Breaking.SIZE).points();
        assertTrue(small > large, small + " and " + large);
    }

    @Test
    void anInputThatNoRightMethodTakesBreaksNothing() throws InterruptedException {
        Report report =
                report(
                        "break-clip-polygon",
                        "{\"window\": [[0, 0], [10, 0], [2, 2], [0, 10]],"
                                + " \"polygon\": [[1, 1], [2, 1], [1, 2]]}");
        assertEquals(0, report.points().total());
        String said = report.diagnostics().get(0).message("en");
        assertTrue(said.contains("; weiler-atherton refuses it: "), said);
        String russian = report.diagnostics().get(0).message("ru");
        assertTrue(russian.contains("; метод weiler-atherton отказывается: "), russian);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "{\"window\": [0, 0, 10, 10]} | the input, field 'segments' is missing"
                        + " | вход, поле «segments»",
                "{\"window\": [0, 0, 10, 10], \"segments\": [[0, 0, 1]]} | /segments/0: only 3 values | /segments/0",
                "[] | the array has 0 inputs; 1 to | в массиве входов: 0",
                "[1] | input 1 must be an object | вход 1: должен быть объект",
                "public class Clip {} | the input is not JSON | вход: это не JSON",
                "{} {} | the input is not JSON | вход: это не JSON",
            })
    void aFaultyInputIsToldInBothLanguages(String sent, String english, String russian)
            throws InterruptedException {
        Report report = report(CLIP, sent);
        assertEquals(GradingVerdict.REFUSED, report.verdict());
        assertEquals(0, report.points().total());
        String said = report.diagnostics().get(0).message("en");
        assertTrue(said.contains(english), said);
        String saidRussian = report.diagnostics().get(0).message("ru");
        assertTrue(saidRussian.contains(russian), saidRussian);
    }

    @Test
    void aTextThatIsTooLongIsRefusedUnread() throws InterruptedException {
        Report report = report(CLIP, "[" + "0,".repeat(40_000) + "0]");
        assertEquals(GradingVerdict.REFUSED, report.verdict());
        assertTrue(report.diagnostics().get(0).message("en").contains("65536"));
    }

    @Test
    void inputsThatTakeTooLongAreToldAndTheOthersCount() throws InterruptedException {
        String sent =
                "[{\"center\": [0, 0], \"radius\": 2000000000}, {\"center\": [1, 2], \"radius\": 3}]";
        Report report;
        JudgeSettings hasty =
                OtherSettings.withCallLimit(Duration.ofMillis(300), OtherSettings.onceInNoBox());
        try (Judge impatient = Judge.start(hasty)) {
            report = report(impatient, "break-circle", sent);
        }
        List<String> said = new ArrayList<>();
        report.diagnostics().forEach(one -> said.add(one.message("en")));
        assertTrue(said.toString().contains("submit a smaller one"), said.toString());
        assertTrue(said.toString().contains("with input 1"), said.toString());
        assertEquals(GradingVerdict.OK, of(report, "axes-twice").verdict());
    }
}
