package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.runner.JudgeSettings;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;

/**
 * Programs as students write them, {@code programs/EXERCISE/NAME.java}. The comment of a wrong one
 * ends in the name of its mistake, in brackets; that of a right one, however unusual, begins with
 * "Right".
 */
class SubmittedProgramsTest {
    private static final long SEED = 20261127;
    private static final Path FOLDER =
            Path.of("src", "test", "resources", "rasterlab", "exercises", "programs");
    private static final Pattern MISTAKE =
            Pattern.compile("/\\*\\* Wrong: [^*]*\\(([-a-z0-9]+)\\)");

    private static Judge judge;

    @BeforeAll
    static void startJudge() {
        judge = Judge.start(JudgeSettings.once());
    }

    @AfterAll
    static void closeJudge() {
        judge.close();
    }

    static List<String> right() throws IOException {
        return programs("Right");
    }

    static List<String> wrong() throws IOException {
        return programs("Wrong");
    }

    private static List<String> programs(String kind) throws IOException {
        try (Stream<Path> all = Files.walk(FOLDER)) {
            return all.filter(one -> one.getFileName().toString().startsWith(kind))
                    .map(one -> FOLDER.relativize(one).toString().replace('\\', '/'))
                    .sorted()
                    .toList();
        }
    }

    private static Exercise exercise(String program) {
        return Catalogue.builtIn().named(program.substring(0, program.indexOf('/')));
    }

    private static Report graded(String program, String source) throws InterruptedException {
        return judge.grade(exercise(program), source, CaseSelection.all(SEED), done -> {});
    }

    @ParameterizedTest(name = "{0} loses points")
    @MethodSource("right")
    void aRightProgramKeepsAllPoints(String program) throws Exception {
        Report report = graded(program, Files.readString(FOLDER.resolve(program)));
        List<String> lost =
                report.cases().stream()
                        .filter(one -> one.verdict() != GradingVerdict.OK)
                        .filter(one -> !one.name().equals("speed"))
                        .map(one -> one.name() + ": " + one.message())
                        .toList();
        assertEquals(List.of(), lost, report.diagnostics().toString());
        assertEquals(exercise(program).points().accuracy(), report.points().accuracy());
    }

    @ParameterizedTest(name = "{0} passes, or its mistake is not named")
    @MethodSource("wrong")
    void aWrongProgramsMistakeIsNamed(String program) throws Exception {
        String source = Files.readString(FOLDER.resolve(program));
        Matcher mistake = MISTAKE.matcher(source);
        assertTrue(mistake.find(), "no mistake in the comment of " + program);
        String key = "mutant.%s.%s".formatted(exercise(program).topic(), mistake.group(1));
        String named =
                Message.isKnown(key)
                        ? Message.of("known-mistake", key).in("en")
                        : Message.of("known-answer", mistake.group(1)).in("en");
        Report report = graded(program, source);
        assertNotEquals(GradingVerdict.OK, report.verdict(), report.diagnostics().toString());
        List<String> said = report.cases().stream().map(one -> one.message()).toList();
        assertTrue(
                said.stream().anyMatch(one -> one.contains(named)),
                () -> named + " is not in " + said + report.diagnostics());
    }
}
