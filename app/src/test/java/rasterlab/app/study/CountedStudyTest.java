package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;

/** Counts of the studies that ship: what is counted is the same on every machine. */
class CountedStudyTest {
    private static double cost(Study counted, String method, String workload) {
        return counted.measurements().stream()
                .filter(one -> one.method().equals(method) && one.workload().equals(workload))
                .findFirst()
                .orElseThrow()
                .cost()
                .medianNanos();
    }

    private static Study shipped(String topic) {
        return ShippedStudies.of(Topics.named(topic)).orElseThrow();
    }

    @Test
    @DisplayName("light and length are counted among a line's operations, or all of its pixels'")
    void operationsOfALineArePerPixel() {
        Study counted = StudyCost.OPERATIONS.of(shipped("line"));
        assertEquals("pixel", counted.item());
        assertEquals(2, cost(counted, "bresenham", "length-4096"), 1);
        assertTrue(cost(counted, "naive", "length-4096") > cost(counted, "bresenham", "length-16"));
    }

    static Stream<Topic<?, ?, ?>> counting() {
        return Topics.all().stream().filter(StudyCost.OPERATIONS::isPossible);
    }

    @ParameterizedTest(name = "what is counted in {0} has no unit, or grows with the workload''s")
    @MethodSource("counting")
    void countsHaveAUnitInBothLanguages(Topic<?, ?, ?> topic) {
        Study counted = StudyCost.OPERATIONS.of(shipped(topic.name()));
        String english = StudyCost.OPERATIONS.words(Language.ENGLISH).item(counted);
        String russian = StudyCost.OPERATIONS.words(Language.RUSSIAN).item(counted);
        assertTrue(russian.matches("\\P{IsLatin}+"), russian);
        String axis = StudyCost.OPERATIONS.words(Language.ENGLISH).briefCostAxis(counted);
        assertEquals("cost: operations counted per " + english, axis);
        assertTrue(counted.measurements().stream().anyMatch(one -> one.cost().timed()));
    }

    @Test
    @DisplayName("the answer's pieces count as work on it")
    void measuresOfTheAnswerAreNoWork() {
        assertFalse(StudyCost.OPERATIONS.isPossible(Topics.named("matrix")));
        assertFalse(Topics.named("clip-polygon").isWork("corners left"));
        assertTrue(Topics.named("clip-polygon").isWork("side tests"));
        assertFalse(Topics.named("line").isWork("levels of light at 0–15°"));
        assertTrue(Topics.named("line").isWork("additions"));
        assertFalse(Topics.named("vertex-normals").isWork("faces left out"));
    }

    @Test
    @DisplayName("many cheap points beat a method that needs few")
    void frontOfSegmentsTellsTheFewestThatAreEnough() {
        String quarter = "flat-quarter-px";
        Study parts = StudyCost.PARTS.of(shipped(new CurveTopic().name()));
        assertEquals("curve", parts.item());
        double fewest = cost(parts, "fewest", quarter);
        assertTrue(fewest > 10 && fewest < 40, "segments of a curve, not of all: " + fewest);
        assertTrue(fewest < cost(parts, "adaptive", quarter));
        assertTrue(cost(parts, "adaptive", quarter) < 2 * fewest);
        ParetoFront front = ParetoFront.of(parts, quarter);
        List<String> best = front.front().stream().map(Measurement::method).toList();
        assertTrue(best.contains("fewest"), best.toString());
        assertFalse(best.contains("uniform"), best.toString());
        assertTrue(StudyView.of(new CurveTopic()).contains(StudyView.PARTS));
        assertFalse(StudyView.of(Topics.named("line")).contains(StudyView.PARTS));
    }
}
