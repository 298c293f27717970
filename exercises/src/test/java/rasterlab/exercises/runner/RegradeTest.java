package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;

/**
 * Grading again what was handed in gives the same verdicts and points: 20 programs 50 times with
 * {@code -Drasterlab.full=true}, then with one batch for the speed. What depends on a time that was
 * measured is printed, not compared.
 */
@Tag("slow")
class RegradeTest {
    private static final Path PROGRAMS = Path.of("src/test/resources/rasterlab/exercises/programs");
    private static final boolean FULL = Boolean.getBoolean("rasterlab.full");
    private static final int SUBMISSIONS = FULL ? 20 : 3;
    private static final int TIMES = FULL ? 50 : 2;
    private static final JudgeSettings SETTINGS =
            JudgeSettings.defaults()
                    .withSpeed(FULL ? JudgeSettings.Speed.ONCE : JudgeSettings.Speed.MEASURED);

    /** The programs, taken evenly out of all, those that are right and those that are not. */
    private static List<Path> programs() throws IOException {
        try (Stream<Path> files = Files.walk(PROGRAMS)) {
            List<Path> all = files.filter(Files::isRegularFile).sorted().toList();
            List<Path> some = new ArrayList<>();
            for (int i = 0; i < SUBMISSIONS; i++) some.add(all.get(i * all.size() / SUBMISSIONS));
            return some;
        }
    }

    @Test
    @Timeout(value = 2, unit = TimeUnit.HOURS)
    void gradingAgainGivesTheSame() throws Exception {
        List<String> differing = new ArrayList<>();
        List<Path> programs = programs();
        try (Judge judge = Judge.start(SETTINGS)) {
            List<String> first = new ArrayList<>();
            for (Path one : programs) first.add(graded(judge, one, first.size()));
            for (int time = 1; time < TIMES; time++)
                for (int i = 0; i < programs.size(); i++) {
                    String again = graded(judge, programs.get(i), i);
                    if (!again.equals(first.get(i)))
                        differing.add(
                                programs.get(i)
                                        + ", time "
                                        + time
                                        + ":\n"
                                        + first.get(i)
                                        + "\n"
                                        + again);
                }
        }
        assertEquals(List.of(), differing);
    }

    private static String graded(Judge judge, Path program, long seed)
            throws IOException, InterruptedException {
        String id = PROGRAMS.relativize(program).getName(0).toString();
        Exercise exercise = Catalogue.builtIn().named(id);
        String source = Files.readString(program);
        Report report = judge.grade(exercise, source, CaseSelection.all(seed), done -> {});
        ScorePoints points = report.points();
        System.out.println(id + ": " + points);
        List<String> lines = new ArrayList<>();
        lines.add(report.verdict() + " " + points.accuracy() + " + " + points.stability());
        for (CaseReport one : report.cases())
            if (!one.name().equals(CaseReport.SPEED)) lines.add(line(one));
        return String.join("\n", lines);
    }

    /** The message may differ: a smaller counterexample is looked for as long as there is time. */
    private static String line(CaseReport one) {
        return one.name() + " " + one.points() + " " + one.verdict();
    }
}
