package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** What is said of the cases whose turn does not come, since the method was stopped. */
class StoppedTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("stopped")
    void onlyTheCaseThatStoppedItHasItsVerdict(GradingVerdict verdict, String source)
            throws Exception {
        Report report = JUDGE.grade(source, CaseSelection.all(1)).forStudent(false);
        List<CaseReport> cases = cases(report);
        assertEquals(verdict, report.verdict());
        assertEquals(verdict, cases.get(0).verdict());
        for (CaseReport later : cases.subList(1, cases.size())) {
            assertEquals(GradingVerdict.NOT_RUN, later.verdict(), later.name());
            assertEquals("not run: stopped before it", later.message(), later.name());
        }
        assertEquals(0, report.points().total());
    }

    static Stream<Arguments> stopped() {
        return Stream.of(
                argumentSet(
                        "cases after the one that hung are too slow",
                        GradingVerdict.TIME_LIMIT,
                        method("while (true);\n")),
                argumentSet(
                        "each case threw what a static initialiser threw",
                        GradingVerdict.RUNTIME_ERROR,
                        Sources.RIGHT.replace(
                                "public void", "static int z = 1 / (1 - 1);\npublic void")));
    }

    private static List<CaseReport> cases(Report report) {
        return report.cases().stream().filter(one -> !one.name().equals("speed")).toList();
    }
}
