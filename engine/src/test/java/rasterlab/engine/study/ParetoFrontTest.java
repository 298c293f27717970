package rasterlab.engine.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Verdict.Kind;

class ParetoFrontTest {
    private static Measurement timed(String method, double nanos, double spread, double error) {
        var rounds = new ArrayList<Double>();
        for (int i = 0; i < 12; i++) rounds.add(nanos * (1 + spread * i));
        return new Measurement(
                method,
                "w",
                16,
                Cost.of(rounds, Map.of()),
                new Deviation(error, 0, 0, 9, ""),
                error < 1e-9 ? Kind.EXACT : Kind.DEGRADED,
                "");
    }

    private static ParetoFront front(Measurement... points) {
        return ParetoFront.of(new Study("line", "pixel", "pixels", List.of(points)), "w");
    }

    private static List<String> names(List<Measurement> points) {
        return points.stream().map(Measurement::method).toList();
    }

    @Test
    void aMethodThatIsSlowerAndLessAccurateIsBeatenByName() {
        ParetoFront front =
                front(
                        timed("rough", 10, 0.001, 5),
                        timed("fine", 20, 0.001, 0),
                        timed("bad", 30, 0.001, 7));
        assertEquals(List.of("rough", "fine"), names(front.front()));
        assertEquals(Map.of("bad", List.of("rough", "fine")), front.beatenBy());
        assertEquals(List.of("rough", "fine"), names(front.corners()));
    }

    @Test
    void timesThatAreNotToldApartBeatNothing() {
        ParetoFront front = front(timed("a", 10, 0.2, 5), timed("b", 12, 0.2, 5));
        assertTrue(front.beatenBy().isEmpty(), front.beatenBy().toString());
    }

    @Test
    void ofMethodsAlikeTheMoreAccurateBeatsTheOther() {
        ParetoFront front = front(timed("a", 10, 0.001, 5), timed("b", 10.1, 0.001, 0));
        assertEquals(Map.of("a", List.of("b")), front.beatenBy());
    }

    @Test
    void errorsWithinTheStatedBoundAreEqual() {
        ParetoFront front = front(timed("a", 10, 0.001, 1e-14), timed("b", 20, 0.001, 0));
        assertEquals(Map.of("b", List.of("a")), front.beatenBy());
    }

    @Test
    void boundOfWhatIsExactIsTheTopicsOwn() {
        for (Topic<?, ?, ?> topic : Topics.all()) {
            double bound = ExactBound.of(topic);
            if (bound == 0) continue;
            assertTrue(topic.correct(new Deviation(bound, 0, 0, 1, "")), topic.name());
            assertTrue(!topic.correct(new Deviation(1.001 * bound, 0, 0, 1, "")), topic.name());
        }
    }
}
