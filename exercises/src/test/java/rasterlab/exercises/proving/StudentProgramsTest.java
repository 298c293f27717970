package rasterlab.exercises.proving;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Programs as students write them are judged as a teacher would.
 *
 * <p>They stand in {@code programs/EXERCISE/right} and {@code programs/EXERCISE/wrong} among the
 * resources. A wrong one has the name of its mistake, a mutant or a faulty method of the topic;
 * what follows a dot tells several apart.
 */
@Tag("slow")
class StudentProgramsTest {
    private static final Path PROGRAMS = Path.of("src/test/resources/rasterlab/exercises/programs");
    private static final long SEED = 20261127;
    private static final int SEEDS = 3;

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

    @ParameterizedTest(name = "{0} loses accuracy points")
    @MethodSource("right")
    void aRightProgramIsFullyAccurate(Path file) throws Exception {
        Exercise exercise = exercise(file);
        Object program = CompiledProgram.of(Files.readString(file));
        for (long seed = SEED; seed < SEED + SEEDS; seed++) {
            List<String> paying = marking(exercise, program, seed).paying();
            List<String> lost =
                    exercise.cases().stream()
                            .filter(one -> one.kind() == Kind.ACCURACY)
                            .map(Case::name)
                            .filter(name -> !paying.contains(name))
                            .toList();
            assertEquals(List.of(), lost, "seed " + seed);
        }
    }

    @ParameterizedTest(name = "{0} is not told its mistake, or keeps all points")
    @MethodSource("wrong")
    void aWrongProgramIsToldItsMistake(Path file) throws Exception {
        Exercise exercise = exercise(file);
        Object program = CompiledProgram.of(Files.readString(file));
        Marking marking = marking(exercise, program, SEED);
        assertTrue(marking.paying().size() < exercise.cases().size(), "it loses no points");
        String mistake = file.getFileName().toString().split("\\.")[0];
        for (String language : List.of("en", "ru")) {
            String told = told(marking, language);
            assertTrue(told.contains(said(exercise.topic(), mistake, language)), told);
        }
    }

    /** All that the student can read: hidden cases tell the class of the error alone. */
    private static String told(Marking marking, String language) {
        String cases =
                marking.reports().stream()
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .map(CaseReport::said)
                        .map(said -> said.in(language))
                        .collect(joining("\n"));
        return cases + "\n" + marking.shared().in(language);
    }

    private static String said(String topic, String mistake, String language) {
        boolean method = mistake.endsWith("-textbook");
        return method ? mistake : Phrase.of("mutant." + topic + "." + mistake).in(language);
    }

    private static Exercise exercise(Path file) {
        return Catalogue.builtIn().named(PROGRAMS.relativize(file).getName(0).toString());
    }

    private static Marking marking(Exercise exercise, Object program, long seed) {
        return TriedMethod.on(exercise, TopicGradings.of(exercise), program, seed).marking();
    }
}
