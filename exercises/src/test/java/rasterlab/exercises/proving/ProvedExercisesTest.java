package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.runner.JudgeSettings;
import rasterlab.exercises.runner.StartedJudge;

/**
 * Every exercise that comes with the program is proved, as {@code ./lab exercises prove} does. Its
 * sources are ours, so they are compiled in this process, and their speed proves nothing.
 */
@Tag("slow")
class ProvedExercisesTest {
    private static final long SEED = 20261127;

    @RegisterExtension
    static final StartedJudge JUDGE =
            new StartedJudge(JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF));

    static List<String> exercises() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .map(Exercise::id)
                .toList();
    }

    @ParameterizedTest(name = "something speaks against {0}")
    @MethodSource("exercises")
    void anExerciseIsProved(String id) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(id);
        Proof proof = Proving.of(exercise, SEED, JUDGE.judge());
        assertEquals(List.of(), proof.faults().stream().map(one -> one.in("en")).toList());
    }
}
