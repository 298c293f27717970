package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.StatedLimits;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.topic.TopicGradings;

class TimedBatchTest {
    private static final Duration USUAL = Duration.ofSeconds(2);
    private static final Exercise CIRCLE = Catalogue.builtIn().named("circle");
    private static final TopicGrading GRADING = TopicGradings.named("circle");
    private static final TopicGrading.TimingInputs SIXTY =
            GRADING.timings(CIRCLE, new Random(1), List.of()).next();

    @Test
    @DisplayName("an exercise that states no time has another than the usual one")
    void hasTheUsualTime() {
        assertEquals(USUAL, batch(Optional.empty()).limit(USUAL));
    }

    @ParameterizedTest(name = "60 inputs of {0} ms have {1} ms")
    @CsvSource({"1, 60", "20, 1200", "50, 2000", "2000, 2000", "5000, 5000"})
    void hasTheStatedTimeForEachInputUpToThatOfACall(int each, int all) {
        TimedBatch batch = batch(Optional.of(Duration.ofMillis(each)));
        assertEquals(Duration.ofMillis(all), batch.limit(USUAL));
        assertEquals(Duration.ofMillis(each), batch.alone(59).limit(USUAL));
    }

    @Test
    @DisplayName("a batch is looked at again although it took no longer than one call may")
    void hidesALongCallOnlyWhereItTookLongerThanOne() {
        TimedBatch stated = batch(Optional.of(Duration.ofMillis(100)));
        assertTrue(stated.mayHideALongCall(100_000_001));
        assertFalse(stated.mayHideALongCall(100_000_000));
        assertFalse(stated.alone(0).mayHideALongCall(Long.MAX_VALUE));
        assertFalse(batch(Optional.empty()).mayHideALongCall(Long.MAX_VALUE));
    }

    private static TimedBatch batch(Optional<Duration> stated) {
        var caps = new StatedLimits(OptionalInt.empty(), OptionalInt.empty(), stated);
        return new TimedBatch(ContractCalls.of(GRADING.contract()), SIXTY, caps);
    }
}
