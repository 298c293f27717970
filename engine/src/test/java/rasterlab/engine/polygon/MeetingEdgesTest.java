package rasterlab.engine.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.polygon.MeetingEdges.EdgePair;

class MeetingEdgesTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void finds(Optional<EdgePair> expected, Points polygon) {
        assertEquals(expected, MeetingEdges.of(polygon.xs(), polygon.ys()));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("a square meets itself", none(), Points.of(0, 0, 4, 0, 4, 4, 0, 4)),
                argumentSet(
                        "minus zero is left of zero", none(), Points.of(0, 0, 4, 0, 4, 4, -0.0, 4)),
                argumentSet("crossing is missed", pair(0, 2), Points.of(0, 0, 4, 4, 0, 4, 4, 0)),
                argumentSet(
                        "touching corner is missed",
                        pair(0, 3),
                        Points.of(0, 0, 8, 0, 8, 6, 4, 0, 0, 6)),
                argumentSet(
                        "corners in one place are missed",
                        pair(2, 5),
                        Points.of(0, 0, 4, 0, 2, 2, 4, 4, 0, 4, 2, 2)),
                argumentSet(
                        "way back along an edge is missed",
                        pair(0, 1),
                        Points.of(0, 0, 8, 0, 4, 0, 4, 4)),
                argumentSet(
                        "way back over a vertical edge is missed",
                        pair(0, 1),
                        Points.of(0, 0, 0, 8, 0, 4, 4, 4)),
                argumentSet(
                        "edges on one line are missed",
                        pair(0, 4),
                        Points.of(0, 0, 6, 0, 6, 6, 4, 6, 4, 0, 2, 0, 2, 6, 0, 6)));
    }

    @Test
    void aHundredThousandCornersAreTestedByTheirNeighboursOnly() {
        Points star = StarPolygon.of(100_000, 1, new Random(1976));
        assertEquals(none(), MeetingEdges.of(star.xs(), star.ys()));
    }

    private static Optional<EdgePair> none() {
        return Optional.empty();
    }

    private static Optional<EdgePair> pair(int one, int other) {
        return Optional.of(new EdgePair(one, other));
    }
}
