package rasterlab.exercises.predicting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.proving.Kill;
import rasterlab.exercises.proving.Proof;
import rasterlab.exercises.proving.Proving;

/** Each exercise of the kind 'predict' pays for the steps of its method and for no others. */
class PredictExercisesTest {
    private static final int SEEDS = 20;

    static List<Exercise> all() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == TaskKind.PREDICT)
                .toList();
    }

    @Test
    void thereAreAtLeastTenEachOnATopicOfItsOwn() {
        assertTrue(all().size() >= 10, all().size() + " exercises");
        assertEquals(all().size(), all().stream().map(Exercise::topic).distinct().count());
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("all")
    void isProved(Exercise exercise) {
        Proof proof = Proving.of(exercise, 3);
        assertEquals(List.of(), proof.faults());
        assertEquals(100, proof.right().get(0).accuracy());
        assertTrue(proof.kills().stream().allMatch(Kill::isRejected));
    }

    @ParameterizedTest
    @MethodSource("all")
    void everySeedDrawsASheetWithDifferentInputs(Exercise exercise) {
        for (long seed = 0; seed < SEEDS; seed++) {
            Sheet sheet = Sheet.of(exercise.topic(), exercise.predicting().orElseThrow(), seed);
            assertTrue(
                    sheet.questions().stream().map(Question::input).distinct().count() > 1,
                    exercise.id() + ", seed " + seed);
            assertTrue(SheetText.open(exercise, seed).length() < HandedAnswers.MOST_CHARACTERS / 4);
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    void theStarterIsASheetWithoutAnswers(Exercise exercise) {
        HandedAnswers read = HandedAnswers.of(exercise, exercise.starter());
        for (Question one : read.sheet().questions())
            assertTrue(one.isOpen(read.answers().get(one.number() - 1)), exercise.id());
    }
}
