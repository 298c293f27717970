package rasterlab.app.findings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.study.HazardMatrix;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.Machine;
import rasterlab.engine.transform.view.ViewTopic;

class FoundWordsTest {
    private static final ViewTopic VIEW = new ViewTopic();
    private static final HazardMatrix NONE =
            new HazardMatrix("view", List.of(), List.of(), List.of());

    private static Measurement timed(String method, double nanos, double error) {
        return timed(method, "points-16", nanos, error);
    }

    private static Measurement timed(String method, String workload, double nanos, double error) {
        var kind = error == 0 ? Verdict.Kind.EXACT : Verdict.Kind.DEGRADED;
        return timed(method, workload, nanos, error, kind);
    }

    private static Measurement timed(
            String method, String workload, double nanos, double error, Verdict.Kind kind) {
        var rounds = new ArrayList<Double>();
        for (int i = 0; i < 12; i++) rounds.add(nanos * (1 + 0.001 * i));
        return new Measurement(
                method,
                workload,
                16,
                Cost.of(rounds, Map.of()),
                new Deviation(error, 0, 0, 9, ""),
                kind,
                "");
    }

    private static Measurement failed(String method, String workload, Verdict.Kind kind) {
        return new Measurement(method, workload, 16, Cost.NONE, Deviation.NONE, kind, "");
    }

    private static String findingText(
            HazardMatrix hazards, Language language, Measurement... measured) {
        var study = new Study("view", "point", "of the largest coordinate", List.of(measured));
        return String.join("\n", new FoundWords(VIEW, study, hazards, language).sentences());
    }

    private static String findingText(Measurement... measured) {
        return findingText(NONE, Language.ENGLISH, measured);
    }

    @Test
    void sentencesSayNoMoreThanTheNumbers() {
        HazardMatrix hazards = HazardMatrix.judged(VIEW, HazardTrial.WALL_LIMIT);
        Measurement quick = timed("one-matrix", 10, 0.5);
        String told = findingText(hazards, Language.ENGLISH, quick, timed("taken-apart", 30, 0));
        assertTrue(told.contains("The quickest exact method: taken-apart (16 points)"), told);
        assertTrue(told.contains("exactness costs 3.00 times as much (between 2.9"), told);
        String open = findingText(hazards, Language.ENGLISH, quick, timed("taken-apart", 10.3, 0));
        assertTrue(open.startsWith("The quickest exact method: taken-apart (16 points)."), open);
    }

    @Test
    @DisplayName("all workloads are listed where one method wins everywhere")
    void winnerOfAllIsToldInShort() {
        Measurement small = timed("taken-apart", "points-16", 10, 0, Verdict.Kind.EXACT);
        Measurement large = timed("taken-apart", "points-256", 10, 0, Verdict.Kind.EXACT);
        assertTrue(
                findingText(small, large)
                        .startsWith("The quickest exact method at every workload: taken-apart.\n"));
        Measurement open = timed("one-matrix", "points-256", 10, 0.5, Verdict.Kind.DEGRADED);
        assertTrue(
                findingText(small, open).startsWith("The quickest exact method: taken-apart (16 "));
    }

    @Test
    @DisplayName("exactness is said to cost nothing where times are not told apart")
    void priceIsToldOnlyWhereIntervalsPart() {
        Measurement wide =
                new Measurement(
                        "taken-apart",
                        "points-16",
                        16,
                        Cost.of(List.of(5.0, 6.0, 9.0, 9.5, 30.0, 40.0, 50.0), Map.of()),
                        new Deviation(0, 0, 0, 9, ""),
                        Verdict.Kind.EXACT,
                        "");
        String open = findingText(wide, timed("one-matrix", 10, 0.5));
        assertTrue(
                open.contains(
                        "At the workload “16 points” it is not told what exactness costs:"
                                + " taken-apart, exact, and one-matrix, not exact, are not told"
                                + " apart."),
                open);
        String another = findingText(timed("slow", 30, 0), wide, timed("one-matrix", 9.2, 0.5));
        assertTrue(another.contains("costs: taken-apart, exact, and one-matrix"), another);
        String faster = findingText(timed("taken-apart", 5, 0), timed("one-matrix", 10, 0.5));
        assertTrue(
                faster.contains(
                        "exactness costs nothing: taken-apart is exact, and no method that is not"
                                + " exact is faster."),
                faster);
        String all = findingText(timed("taken-apart", 5, 0), timed("one-matrix", 5, 0));
        assertTrue(all.contains("“16 points” every method that was timed is exact."), all);
    }

    @Test
    @DisplayName("a refusal or an acceptable answer counts as a failure at a workload")
    void firstFailureIsNoRefusal() {
        Measurement[] measured = {
            failed("convex", "points-16", Verdict.Kind.REFUSED),
            timed("one-matrix", "points-64", 10, 0.5),
            timed("taken-apart", "points-256", 10, 9, Verdict.Kind.WRONG),
            failed("loose", "points-256", Verdict.Kind.CRASHED)
        };
        String told = findingText(measured);
        assertTrue(
                told.contains(
                        "Methods first fail at the workload “256 points”: loose (crashed),"
                                + " taken-apart (wrong). The first workload that a method refuses"
                                + " is “16 points”: convex. The first workload with an answer"
                                + " that is acceptable but not exact is “64 points”: one-matrix."),
                told);
        String russian = findingText(NONE, Language.RUSSIAN, measured);
        assertTrue(
                russian.contains("методы отказываются от нагрузки «16 точек»: convex."), russian);
        assertTrue(
                findingText(timed("one-matrix", 10, 0.5))
                        .contains("No method fails at any workload"));
    }

    private static String hardest(Language language, Verdict.Kind... kinds) {
        Hazard<?> hazard = VIEW.hazards().get(1);
        var cells = new ArrayList<VerdictCell>();
        var methods = new ArrayList<String>();
        for (Verdict.Kind kind : kinds) {
            String method = "m" + methods.size();
            methods.add(method);
            var verdict = new Verdict(kind, Deviation.NONE, "");
            cells.add(new VerdictCell(hazard.name(), method, verdict, kind));
        }
        var matrix = new HazardMatrix("view", methods, List.of(hazard.name()), cells);
        String said = findingText(matrix, language, timed("taken-apart", 5, 0));
        return said.substring(said.lastIndexOf('\n') + 1).replaceAll("[“«].*[”»]", "X");
    }

    @Test
    @DisplayName("a refusal of a hazard counts as a failure")
    void hardestHazardTellsFailuresFromRefusals() {
        Verdict.Kind refused = Verdict.Kind.REFUSED;
        Verdict.Kind degraded = Verdict.Kind.DEGRADED;
        assertEquals(
                "No method fails on any hazard. The hazard that most methods refuse is X: 3 of 3;"
                        + " a refusal is an answer too.",
                hardest(Language.ENGLISH, refused, refused, refused));
        assertEquals("No method fails on any hazard.", hardest(Language.ENGLISH, degraded));
        assertEquals(
                "The hazard that most methods fail on is X: 2 of 5; 2 refuse it; 1 gives an"
                        + " acceptable answer.",
                hardest(
                        Language.ENGLISH,
                        Verdict.Kind.WRONG,
                        refused,
                        Verdict.Kind.ENDLESS,
                        refused,
                        degraded));
        assertEquals(
                "Трудный случай, на котором ошибается больше всего методов,\u00a0— X:"
                        + " 1\u00a0из\u00a02; 1 отказывается.",
                hardest(Language.RUSSIAN, Verdict.Kind.CRASHED, refused));
    }

    private static String measured(Language language, double slowest) {
        var how =
                new StudyConditions(
                        StudySettings.quick(),
                        Instant.parse("2026-11-28T02:30:00Z"),
                        Machine.here(),
                        1.2,
                        3.5,
                        Map.of("points-16", List.of(1.0, 1.0, slowest, slowest, slowest)),
                        true);
        var measured = List.of(timed("taken-apart", 5, 0));
        var study = new Study("view", "point", "coordinates", measured, Optional.of(how));
        return new FoundWords(VIEW, study, NONE, language).measured(how);
    }

    @Test
    @DisplayName("a machine too busy to conclude is told as thousands of per cent")
    void muchNoiseIsToldInTimes() {
        String quiet = measured(Language.ENGLISH, 1.1);
        assertTrue(quiet.contains("median of a fixed load was off by up to"), quiet);
        assertTrue(quiet.contains(" % in the same rounds; seed 1."), quiet);
        String busy = measured(Language.ENGLISH, 382);
        assertTrue(busy.contains("was off by a factor of up to 382 in the same rounds"), busy);
        assertTrue(busy.contains("too busy to conclude about methods that differ by less"), busy);
        assertFalse(busy.contains("%"), busy);
        String russian = measured(Language.RUSSIAN, 382);
        assertTrue(russian.contains("отклонялась в пределах до 382 раз: машина слишком"), russian);
    }

    @Test
    @DisplayName("a winner is named once for each workload, or a sentence ends in two stops")
    void aWinnerIsNamedOnceWithAllItsWorkloads() {
        var study =
                new Study(
                        "line",
                        "pixel",
                        "pixels",
                        List.of(
                                timed("dda", "length-16", 10, 0),
                                timed("dda", "length-64", 10, 0),
                                timed("dda", "length-256", 10, 0),
                                timed("bresenham", "length-256", 10, 0)));
        assertEquals(
                "Самый быстрый точный метод: dda (отрезки по 16\u00a0пикс.; отрезки по 64\u00a0пикс.)."
                        + " Какой точный метод быстрее всех, измерение на этой машине в то время"
                        + " не показало на нагрузках: отрезки по 256\u00a0пикс.",
                new FoundWords(new LineTopic(), study, NONE, Language.RUSSIAN).sentences().get(0));
    }
}
