package rasterlab.exercises.proving;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.runner.JudgeSettings;
import rasterlab.exercises.runner.StartedJudge;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Programs as students write them are judged as a teacher would.
 *
 * <p>They stand in {@code programs/EXERCISE/right} and {@code programs/EXERCISE/wrong} among the
 * resources. A wrong one has the name of its mistake: a mutant, a slip, a change of the right
 * answer, a faulty method or an own word of the topic; what follows a dot tells several apart. A
 * right one keeps all points but those for speed; one whose name ends in {@code .plain} may lose
 * some at the borders of doubles, for stability alone. Of one that ends in {@code .unnamed} the
 * points alone tell that it is wrong. All are tried in this process, the right ones with several
 * seeds; one of each exercise is handed in as by a student.
 */
@Tag("slow")
class StudentProgramsTest {
    private static final Path PROGRAMS = Path.of("src/test/resources/rasterlab/exercises/programs");
    private static final long SEED = 20261127;
    private static final int SEEDS = 3;
    private static final Map<String, Map<Case, List<TopicGrading.GradedCall>>> CALLS =
            new HashMap<>();

    @RegisterExtension
    static final StartedJudge JUDGE =
            new StartedJudge(JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF));

    @AfterAll
    static void forgetCalls() {
        CALLS.clear();
    }

    static Stream<Arguments> right() throws IOException {
        return programs("right");
    }

    static Stream<Arguments> wrong() throws IOException {
        return programs("wrong");
    }

    private static Stream<Arguments> programs(String kind) throws IOException {
        try (Stream<Path> files = Files.walk(PROGRAMS)) {
            return files
                    .filter(file -> file.getParent().endsWith(kind))
                    .filter(Files::isRegularFile)
                    .sorted()
                    .toList()
                    .stream()
                    .map(
                            file ->
                                    Arguments.of(
                                            Named.of(PROGRAMS.relativize(file).toString(), file)));
        }
    }

    /** The first right program of each exercise. */
    static Stream<Arguments> handedIn() throws IOException {
        Set<String> seen = new HashSet<>();
        return programs("right").filter(one -> seen.add(exercise(file(one)).id()));
    }

    private static Path file(Arguments arguments) {
        return (Path) ((Named<?>) arguments.get()[0]).getPayload();
    }

    @ParameterizedTest(name = "{0} is handed in and loses points")
    @MethodSource("handedIn")
    void aRightProgramKeepsItsPointsWhereItIsHandedIn(Path file) throws Exception {
        Exercise exercise = exercise(file);
        CaseSelection cases = CaseSelection.all(SEED);
        Report report = JUDGE.judge().grade(exercise, Files.readString(file), cases, done -> {});
        List<String> names = names(exercise, kept(file));
        List<String> lost =
                report.cases().stream()
                        .filter(one -> names.contains(one.name()) && one.points() < one.of())
                        .map(one -> one.name() + ": " + one.message())
                        .toList();
        assertEquals(List.of(), lost, report.diagnostics().toString());
        assertEquals(exercise.points().accuracy(), report.points().accuracy());
    }

    @ParameterizedTest(name = "{0} loses points")
    @MethodSource("right")
    void aRightProgramKeepsItsPointsWhateverTheSeed(Path file) throws Exception {
        Exercise exercise = exercise(file);
        List<String> names = names(exercise, kept(file));
        Object program = CompiledProgram.of(Files.readString(file));
        for (long seed = SEED; seed < SEED + SEEDS; seed++) {
            GradedMethod tried = GradedMethod.on(exercise, calls(exercise, seed), program);
            List<String> failed = tried.failed();
            List<String> lost = names.stream().filter(failed::contains).toList();
            assertEquals(List.of(), lost, "seed " + seed);
            assertEquals(List.of(), tried.breaking(), "properties, seed " + seed);
        }
    }

    @ParameterizedTest(name = "{0} is not told its mistake, or keeps all points")
    @MethodSource("wrong")
    void aWrongProgramIsToldItsMistake(Path file) throws Exception {
        GradedMethod tried = tried(file);
        assertFalse(tried.failed().isEmpty(), "it loses no points");
        if (isMarked(file, "unnamed")) return;
        String mistake = file.getFileName().toString().split("\\.")[0];
        for (String language : List.of("en", "ru")) {
            String told = readableText(tried.marking, language);
            assertTrue(told.contains(mistakeText(exercise(file).topic(), mistake, language)), told);
        }
    }

    /** All but a tenth have a name that the test above asks for. */
    @Test
    void nineInTenWrongProgramsHaveAMistakeWithAName() throws IOException {
        List<Path> all = wrong().map(StudentProgramsTest::file).toList();
        long unnamed = all.stream().filter(file -> isMarked(file, "unnamed")).count();
        assertTrue(10 * unnamed <= all.size(), unnamed + " of " + all.size() + " have none");
    }

    /** Exercises of which a check on the student's own computer tells the mistake, too. */
    private static final Set<String> TOLD_BY_OPEN_CASES =
            Set.of("point-in-polygon", "polygon-fill", "hermite", "gouraud");

    static Stream<Arguments> toldByOpenCases() throws IOException {
        return programs("wrong")
                .filter(one -> TOLD_BY_OPEN_CASES.contains(exercise(file(one)).id()));
    }

    @ParameterizedTest(name = "{0} is told its mistake by the server alone")
    @MethodSource("toldByOpenCases")
    void theOpenCasesAloneTellTheMistake(Path file) throws Exception {
        Exercise exercise = exercise(file);
        List<Case> open =
                exercise.cases().stream()
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .toList();
        GradedMethod tried =
                Marked.on(
                        exercise,
                        open,
                        TopicGradings.of(exercise),
                        CompiledProgram.of(Files.readString(file)),
                        SEED);
        String mistake = file.getFileName().toString().split("\\.")[0];
        for (String language : List.of("en", "ru")) {
            String told = readableText(tried.marking, language);
            assertTrue(told.contains(mistakeText(exercise.topic(), mistake, language)), told);
        }
    }

    /** All that the student can read: hidden cases tell the class of the error alone. */
    private static String readableText(Marking marking, String language) {
        String cases =
                marking.reports().stream()
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .map(CaseReport::explanation)
                        .map(said -> said.in(language))
                        .collect(joining("\n"));
        return cases + "\n" + marking.shared().in(language);
    }

    private static String mistakeText(String topic, String mistake, String language) {
        for (String key :
                List.of(
                        "mutant." + topic + "." + mistake,
                        "slip." + topic + "." + mistake,
                        "change." + mistake))
            if (Message.isKnown(key)) return Message.of("known-mistake", key).in(language);
        String own = "mistake." + mistake;
        return Message.isKnown(own) ? Message.of(own).in(language) : mistake;
    }

    private static Predicate<Case> kept(Path file) {
        return one -> !isMarked(file, "plain") || one.kind() == Criterion.ACCURACY;
    }

    private static boolean isMarked(Path file, String mark) {
        return file.getFileName().toString().endsWith("." + mark + ".java");
    }

    private static List<String> names(Exercise exercise, Predicate<Case> kept) {
        return exercise.cases().stream().filter(kept).map(Case::name).toList();
    }

    private static Exercise exercise(Path file) {
        return Catalogue.builtIn().named(PROGRAMS.relativize(file).getName(0).toString());
    }

    private static GradedMethod tried(Path file) throws Exception {
        Exercise exercise = exercise(file);
        Object program = CompiledProgram.of(Files.readString(file));
        return GradedMethod.on(exercise, calls(exercise, SEED), program);
    }

    /** The calls of a seed, whose right answers are worked out once for all its programs. */
    private static Map<Case, List<TopicGrading.GradedCall>> calls(Exercise exercise, long seed) {
        return CALLS.computeIfAbsent(
                exercise.id() + " " + seed,
                key -> GradedMethod.calls(exercise, TopicGradings.of(exercise), seed));
    }
}
