package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

class HandedInputTest {
    private static final Exercise CIRCLE =
            Catalogue.builtIn().all().stream()
                    .filter(one -> one.id().equals("break-circle"))
                    .findFirst()
                    .orElseThrow();

    @TempDir Path folder;

    private static String radius(int radius) {
        return "{\"center\":[0,0],\"radius\":" + radius + "}";
    }

    @Test
    void starterAndWhatIsNoJsonGiveWay() {
        assertEquals(radius(1), HandedInput.added(CIRCLE, CIRCLE.starter(), radius(1)));
        assertEquals(radius(1), HandedInput.added(CIRCLE, "[{", radius(1)));
    }

    @Test
    void earlierInputsStayAsFarAsTheExerciseTakesThem() {
        String source = "";
        for (int i = 1; i <= 6; i++) source = HandedInput.added(CIRCLE, source, radius(i));
        assertEquals(
                "[\n  %s,\n  %s,\n  %s,\n  %s,\n  %s\n]"
                        .formatted(radius(2), radius(3), radius(4), radius(5), radius(6)),
                source);
        assertEquals(radius(6), HandedInput.last(source));
    }

    @Test
    void sameInputIsHandedInOnce() {
        String spaced = "{\"center\": [0, 0], \"radius\": 1}";
        assertEquals(spaced, HandedInput.added(CIRCLE, radius(1), spaced));
    }

    @Test
    void inputFromALabIsTriedAndAnsweredWithWhatEachMethodDid() throws Exception {
        try (var trial = new Trial(folder)) {
            trial.model.handIn("break-circle", radius(0));
            ExerciseState answered = trial.await("an answer", state -> state.outcome().isPresent());
            assertEquals("break-circle", answered.exercise().id());
            assertEquals(radius(0), answered.source());
            List<String> broken =
                    answered.outcome().orElseThrow().cases().stream()
                            .filter(one -> one.right())
                            .map(CaseResult::name)
                            .toList();
            assertEquals(true, broken.contains("radius-0-skipped"), broken.toString());
        }
    }
}
