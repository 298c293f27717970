package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static rasterlab.exercises.Sources.method;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** A case in which the method was stopped is lost, and no other, up to five of them. */
@Tag("slow")
class StoppedTest {
    @RegisterExtension
    static final StartedJudge JUDGE =
            new StartedJudge(JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF));

    /** Every call that hangs takes all of its processor time, so there is less of it. */
    @RegisterExtension
    static final StartedJudge STRICT =
            new StartedJudge(
                    OtherSettings.withCallLimit(
                            Duration.ofMillis(500),
                            JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF)));

    @Test
    @DisplayName("a loop on single points takes the later cases away")
    void onlyTheCaseThatHangsIsLost() throws Exception {
        Report report =
                STRICT.grade(
                        Sources.RIGHT.replace("long dx", "while (x0 == x1 && y0 == y1);\nlong dx"),
                        CaseSelection.all(1));
        for (CaseReport one : cases(report)) {
            boolean point = List.of("single-point-is-skipped", "points").contains(one.name());
            GradingVerdict right = point ? GradingVerdict.TIME_LIMIT : GradingVerdict.OK;
            assertEquals(right, one.verdict(), () -> one.name() + ": " + one.message());
        }
        assertEquals(88, report.points().accuracy() + report.points().stability());
    }

    @Test
    @DisplayName("a method that always hangs is asked without end, or the rest is called too slow")
    void afterFiveStopsTheRestIsNotRun() throws Exception {
        Report report = STRICT.grade(method("while (true);\n"), CaseSelection.all(1));
        List<CaseReport> cases = cases(report.forStudent(false));
        assertEquals(GradingVerdict.TIME_LIMIT, report.verdict());
        for (CaseReport stopped : cases.subList(0, Student.MOST_STOPS))
            assertEquals(GradingVerdict.TIME_LIMIT, stopped.verdict(), stopped.name());
        for (CaseReport later : cases.subList(Student.MOST_STOPS, cases.size()))
            assertEquals(GradingVerdict.NOT_RUN, later.verdict(), later.name());
        assertEquals(
                "not run: your method was stopped in 5 cases before",
                cases.get(Student.MOST_STOPS).message());
        assertEquals(0, report.points().total());
    }

    @Test
    @DisplayName("each case threw what a static initialiser threw")
    void aMethodThatCannotBeLoadedSaysSoOnce() throws Exception {
        String source =
                Sources.RIGHT.replace("public void", "static int z = 1 / (1 - 1);\npublic void");
        Report report = JUDGE.grade(source, CaseSelection.all(1)).forStudent(false);
        List<CaseReport> cases = cases(report);
        assertEquals(GradingVerdict.RUNTIME_ERROR, report.verdict());
        assertEquals(GradingVerdict.RUNTIME_ERROR, cases.get(0).verdict());
        for (CaseReport later : cases.subList(1, cases.size()))
            assertEquals(GradingVerdict.NOT_RUN, later.verdict(), later.name());
        assertEquals("not run: your method cannot be loaded", cases.get(1).message());
        assertEquals(0, report.points().total());
    }

    @Test
    @DisplayName("a method that takes 3 s of its 8 s in each call is asked to the end")
    void allCallsTogetherHaveALimit() throws Exception {
        String slow =
                "double waste = 1; for (int i = 0; i < 400_000_000; i++) waste = Math.sqrt(waste + i);\n"
                        + "if (waste == 0) return;\nlong dx";
        Report report = JUDGE.grade(Sources.RIGHT.replace("long dx", slow), CaseSelection.all(1));
        List<CaseReport> cases = cases(report);
        CaseReport last = cases.get(cases.size() - 1);
        assertEquals(GradingVerdict.NOT_RUN, last.verdict(), last.message());
    }

    private static List<CaseReport> cases(Report report) {
        return report.cases().stream().filter(one -> !one.name().equals("speed")).toList();
    }
}
