package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.runner.JudgeSettings;

/** Every exercise that comes with the program is proved, as {@code ./lab exercises prove} does. */
class ProvedExercisesTest {
    private static final long SEED = 20261127;

    private static Judge judge;

    static List<String> exercises() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == Exercise.Form.WRITE)
                .map(Exercise::id)
                .toList();
    }

    @BeforeAll
    static void startJudge() {
        judge = Judge.start(JudgeSettings.once());
    }

    @AfterAll
    static void closeJudge() {
        judge.close();
    }

    @ParameterizedTest(name = "something speaks against {0}")
    @MethodSource("exercises")
    void anExerciseIsProved(String id) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(id);
        Proof proof = Proving.of(exercise, SEED, judge);
        assertEquals(List.of(), proof.faults().stream().map(one -> one.in("en")).toList());
    }
}
