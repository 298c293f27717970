package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Checks what a student is shown and what not. */
class ReportTest {
    private static final CasePicture PICTURE =
            new CasePicture("input", new byte[1], Message.rows("#"), Optional.empty());

    @ParameterizedTest
    @CsvSource({
        "OPEN,           false, gap, pixel (1; 1) is missing, true",
        "VERDICT_ONLY,   false, gap, wrong pixels on a hidden input, false",
        "VERDICT_ONLY,   true,  gap, wrong pixels on a hidden input, false",
        "AFTER_DEADLINE, false, gap, wrong pixels on a hidden input, false",
        "AFTER_DEADLINE, true,  gap, pixel (1; 1) is missing, true",
        "NEVER,          true,  hidden, wrong pixels on a hidden input, false",
    })
    void aHiddenCaseTellsOnlyTheClassOfTheError(
            Disclosure visibility, boolean late, String name, String message, boolean shown) {
        CaseReport one =
                new CaseReport(
                        "gap",
                        visibility,
                        GradingVerdict.WRONG,
                        0,
                        3,
                        Message.quoted("pixel (1; 1) is missing"),
                        List.of(PICTURE),
                        "{}");
        Report report =
                new Report(
                        GradingVerdict.WRONG,
                        new ScorePoints(0, 0, 0, 3),
                        List.of(one),
                        List.of(),
                        "",
                        0);
        CaseReport cut = report.forStudent(late).cases().get(0);
        assertEquals(name, cut.name());
        assertEquals(message, cut.message());
        assertEquals(shown ? List.of(PICTURE) : List.of(), cut.pictures());
        assertEquals(shown ? "{}" : "", cut.scene());
        assertEquals(3, cut.of());
    }

    /** The one that is judged again changes its own points and the verdict, and nothing beside. */
    @ParameterizedTest
    @CsvSource({
        "false, 5, 1, OK, WRONG",
        "true, 2, 4, OK, WRONG",
        "true, 2, 1, TIME_LIMIT, TIME_LIMIT"
    })
    void oneCaseThatIsJudgedAgainChangesNothingElse(
            boolean stability, int accuracy, int stable, GradingVerdict now, GradingVerdict whole) {
        Report former =
                new Report(
                        GradingVerdict.WRONG,
                        new ScorePoints(2, 1, 1, 10),
                        List.of(
                                judged("gap", GradingVerdict.WRONG, 0),
                                judged("steep", GradingVerdict.WRONG, 0),
                                CaseReport.withheld(2, "steep lines", "крутые отрезки"),
                                judged(CaseReport.SPEED, GradingVerdict.NOT_MEASURED, 0)),
                        List.of(),
                        "bubblewrap",
                        7);
        CaseReport again = judged("gap", now, now == GradingVerdict.OK ? 3 : 0);
        Report changed = former.withCase(again, stability);
        assertEquals(new ScorePoints(accuracy, stable, 1, 10), changed.points());
        assertEquals(whole, changed.verdict());
        assertEquals(again, changed.cases().get(0));
        assertEquals(former.cases().subList(1, 4), changed.cases().subList(1, 4));
        assertEquals(7, changed.nanosPerItem());
    }

    @Test
    void oneCaseThatIsRightAtLastMakesTheReportRight() {
        Report former =
                new Report(
                        GradingVerdict.WRONG,
                        new ScorePoints(0, 0, 0, 4),
                        List.of(
                                judged("gap", GradingVerdict.WRONG, 0),
                                judged(CaseReport.SPEED, GradingVerdict.NOT_MEASURED, 0)),
                        List.of(),
                        "",
                        0);
        assertEquals(
                GradingVerdict.OK,
                former.withCase(judged("gap", GradingVerdict.OK, 3), false).verdict());
        CaseReport other = judged("none", GradingVerdict.OK, 3);
        assertThrows(IllegalArgumentException.class, () -> former.withCase(other, false));
    }

    private static CaseReport judged(String name, GradingVerdict verdict, int points) {
        return new CaseReport(
                name, Disclosure.OPEN, verdict, points, 3, Message.NONE, List.of(), "");
    }

    @Test
    void whatDoesNotCountIsToldToItsStudentWithTheReason() {
        CaseReport line = CaseReport.withheld(3, "steep lines", "крутые отрезки");
        assertEquals(line, line.forStudent(false));
        assertTrue(line.message("en").endsWith(": steep lines"), line.message("en"));
        assertTrue(line.message("ru").endsWith(": крутые отрезки"), line.message("ru"));
        assertEquals("−3", CaseReport.pointsOf(line.points(), line.of()));
    }

    @ParameterizedTest
    @CsvSource({
        "1.0, 10",
        "1.5, 10",
        "1.64, 10",
        "1.66, 7",
        "3.0, 7",
        "7.9, 4",
        "8.7, 4",
        "8.9, 0"
    })
    void speedIsPaidInBands(double ratio, int points) {
        assertEquals(points, measured(2 * ratio, 2, false, 10).points());
    }

    private static CaseReport measured(double nanos, double reference, boolean printed, int of) {
        int band = SpeedPoints.band(nanos / reference, OptionalInt.empty());
        return SpeedPoints.measured(UnaryOperator.identity(), nanos, reference, printed, of, band);
    }

    @ParameterizedTest(name = "{0} times, before in band {1}: not in band {2}")
    @CsvSource({
        "1.6, 0, 0",
        "1.9, 0, 0",
        "2.0, 0, 1",
        "1.6, 1, 0",
        "1.7, 1, 1",
        "3.8, 1, 1",
        "4.0, 1, 2",
        "3.2, 2, 1",
        "10.3, 2, 2",
        "10.5, 2, 3",
        "1.0, 3, 0"
    })
    void aSourceStaysInItsBandNearTheEnd(double ratio, int before, int band) {
        assertEquals(band, SpeedPoints.band(ratio, OptionalInt.of(before)));
    }

    @Test
    void aMachineThatIsTooBusyCostsNothing() {
        CaseReport speed = SpeedPoints.unsettled(10, 0);
        assertEquals(GradingVerdict.NOT_MEASURED, speed.verdict());
        assertEquals(10, speed.points());
        assertTrue(speed.message().contains("this costs nothing"), speed.message());
        CaseReport slow = SpeedPoints.unsettled(10, 1);
        assertEquals(7, slow.points(), "slow for certain");
        assertTrue(slow.message("en").contains("7 of 10 points are the most"), slow.message("en"));
        assertTrue(slow.message("ru").contains("баллов: 7 из 10"), slow.message("ru"));
        assertFalse(slow.message("en").contains("costs nothing"), slow.message("en"));
    }

    @ParameterizedTest(name = "a speed that earns nothing is called right: {0} of {1}")
    @CsvSource({"9, 10, TOO_SLOW", "7.9, 10, OK", "9, 0, OK"})
    void speedWithoutPointsIsTooSlow(double ratio, int of, GradingVerdict verdict) {
        CaseReport speed = measured(ratio, 1, false, of);
        assertEquals(verdict, speed.verdict());
        var told = PublishedVerdict.of(verdict);
        assertEquals("ok", told.code(), "scripts know no other");
        assertEquals(verdict.code(), told.codeFor(speed.points(), of));
    }

    @ParameterizedTest(name = "times, ratio or what full points need are not told: {1}")
    @CsvSource({
        "en, 2.26, '2.26 ns per pixel, the reference 2.00 ns, ratio 1.13; full points up to 1.5'",
        "ru, 9.00, '9,00\u00a0нс на пиксель, у эталона 2,00\u00a0нс, отношение 4,50; все баллы\u00a0— до 1,5'",
        "en, 20, '20.00 ns per pixel, the reference 2.00 ns, ratio 10.00; full points up to 1.5,"
                + " none above 8'",
    })
    void speedTellsWhatWasMeasured(String language, double nanos, String said) {
        assertEquals(said, measured(nanos, 2, false, 10).message(language));
    }

    @Test
    void printingIsNamedWhereItCostPoints() {
        String printing = "printing is part of that time";
        assertTrue(measured(9, 1, true, 10).message().contains(printing));
        assertFalse(measured(1.2, 1, true, 10).message().contains(printing));
    }

    @Test
    void twoPicturesOfOneKindAreRefused() {
        var thrown =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> drawn(GradingVerdict.WRONG, List.of(PICTURE, PICTURE)));
        assertEquals("two pictures of 'gap' are of one kind", thrown.getMessage());
    }

    private static CaseReport drawn(GradingVerdict verdict, List<CasePicture> pictures) {
        return new CaseReport("gap", Disclosure.OPEN, verdict, 0, 3, Message.NONE, pictures, "{}");
    }

    @Test
    void hiddenCasesAreToldApart() {
        assertEquals("hidden 2", CaseReport.ownTitle(CaseReport.hidden(2), "en").orElseThrow());
        assertEquals("скрытый 2", CaseReport.ownTitle(CaseReport.hidden(2), "ru").orElseThrow());
    }

    @Test
    void theIsolationIsToldInRussian() {
        assertEquals(
                "только ограничения процесса", Report.isolationIn("ru", "process limits only"));
        assertEquals("bubblewrap", Report.isolationIn("ru", "bubblewrap"));
    }
}
