package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;

/** A source with one mistake is named, loses about one mistake, and is timed. */
@Tag("slow")
class OneMistakeGradedTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    /** The messages where the lines were taken for right ones, however busy the machine is. */
    private static final Set<String> TIMED =
            Set.of(
                    "speed.measured",
                    "speed.worthless",
                    "speed.slow",
                    "speed.unsettled",
                    "speed.unsettled-slow");

    @DisplayName("one mistake costs the points for speed as well")
    @ParameterizedTest(name = "{2}")
    @CsvSource(
            delimiter = '|',
            value = {
                "k <= n         | k <= n + 1                    | it goes one pixel beyond the last end  | 84",
                "k <= n         | k < n                         | the last pixel is missing              | 82",
                "out.plot(x, y);| out.plot(x, y);out.plot(x, y);| each pixel is drawn twice              | 85",
                "y1 < y0 ? -1   | y1 < y0 ? 1                   | it goes the wrong way in y             | 79"
            })
    void isNamedAndTimed(String right, String wrong, String said, int points) throws Exception {
        String source = Sources.RIGHT.replace(right, wrong);
        Report report = JUDGE.grade(source, CaseSelection.all(7));
        String all = report.diagnostics().toString();
        assertTrue(all.contains("One mistake explains all that is wrong – " + said), all);
        assertEquals(points, report.points().accuracy() + report.points().stability());
        assertTrue(TIMED.containsAll(saidOfSpeed(report)), report.cases()::toString);
    }

    private static List<String> saidOfSpeed(Report report) {
        return report.cases().stream()
                .filter(one -> one.name().equals("speed"))
                .flatMap(one -> one.explanation().sentences().stream())
                .map(Message.Sentence::key)
                .toList();
    }
}
