package rasterlab.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class MeshTest {
    private static final double[] SQUARE = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0};

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(double[] xyz, int[] face, String message) {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class, () -> new Mesh(xyz, new int[][] {face}));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        int[] triangle = {0, 1, 2};
        return Stream.of(
                argumentSet(
                        "half a vertex is accepted",
                        new double[] {0, 0},
                        triangle,
                        "vertices must have 3 numbers each, got 2 in all"),
                argumentSet(
                        "a vertex that is no number is accepted",
                        new double[] {0, 0, 0, 1, Double.NaN, 0, 0, 1, 0},
                        triangle,
                        "vertex 1: y must be finite, got NaN"),
                argumentSet(
                        "a corner without vertex is accepted",
                        SQUARE,
                        new int[] {0, 1, 4},
                        "face 0: corner must be a vertex from 0 to 3, got 4"),
                argumentSet(
                        "a negative corner is accepted",
                        SQUARE,
                        new int[] {0, 1, -1},
                        "face 0: corner must be a vertex from 0 to 3, got -1"),
                argumentSet(
                        "repeated corners are counted",
                        SQUARE,
                        new int[] {0, 1, 1, 0},
                        "face 0: at least 3 different corners are needed, got [0, 1, 1, 0]"),
                argumentSet(
                        "a face without area is accepted",
                        new double[] {0, 0, 0, 1, 1, 1, 3, 3, 3},
                        triangle,
                        "face 0: corners [0, 1, 2] span no area"),
                argumentSet(
                        "a narrow face is accepted where its area has no finite square",
                        new double[] {0, 0, 0, 2, 0, 0, 0, 6.7e153, 0},
                        triangle,
                        "face 0: corners [0, 1, 2] span no area"),
                argumentSet(
                        "a bent face is accepted",
                        new double[] {0, 0, 0, 4, 0, 0, 4, 4, 1, 0, 4, 0},
                        new int[] {0, 1, 2, 3},
                        "face 0: corner 1 lies off the plane of the others"),
                argumentSet(
                        "an inward corner is accepted",
                        new double[] {0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 0},
                        new int[] {0, 1, 2, 3},
                        "face 0: corner 2 turns inwards, faces must be convex"),
                argumentSet(
                        "an inward corner that is listed twice is accepted",
                        new double[] {0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 0},
                        new int[] {0, 1, 2, 2, 3},
                        "face 0: corner 2 turns inwards, faces must be convex"),
                argumentSet(
                        "a pentagram is accepted",
                        pentagon(),
                        new int[] {0, 2, 4, 1, 3},
                        "face 0: corners [0, 2, 4, 1, 3] go round 2 times, faces must be convex"),
                argumentSet(
                        "a square twice round is accepted",
                        SQUARE,
                        new int[] {0, 1, 2, 3, 0, 1, 2, 3},
                        "face 0: corners [0, 1, 2, 3, 0, 1, 2, 3] go round 2 times,"
                                + " faces must be convex"));
    }

    /** Five corners counter-clockwise on a circle. */
    private static double[] pentagon() {
        return IntStream.range(0, 15)
                .mapToDouble(
                        i ->
                                switch (i % 3) {
                                    case 0 -> Math.cos(i / 3 * 0.4 * Math.PI);
                                    case 1 -> Math.sin(i / 3 * 0.4 * Math.PI);
                                    default -> 0;
                                })
                .toArray();
    }

    @Test
    @DisplayName("a repeated or straight corner is refused")
    void acceptsCornersThatDoNotTurn() {
        var mesh = new Mesh(SQUARE, new int[][] {{0, 1, 1, 2, 3}});
        assertEquals(1, mesh.normalZ(0));
        double[] straight = {0, 0, 0, 2, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0};
        assertEquals(1, new Mesh(straight, new int[][] {{0, 1, 2, 3, 4}}).normalZ(0));
    }

    @Test
    @DisplayName("the normal points inwards")
    void normalPointsToTheCounterClockwiseSide() {
        var mesh = new Mesh(SQUARE, new int[][] {{0, 1, 2, 3}});
        assertEquals(0, mesh.normalX(0));
        assertEquals(0, mesh.normalY(0));
        assertEquals(1, mesh.normalZ(0));
    }

    @ParameterizedTest(name = "sides of {0} and {1}")
    @CsvSource({"3, 5", "1e77, 2e77", "1e100, 1e92", "1.1e154, 1.1e154"})
    void normalHasLengthOneHoweverLargeTheFaceIs(double width, double height) {
        double[] xyz = {0, 0, 0, width, 0, 0, 0, height, 0};
        assertEquals(1, new Mesh(xyz, new int[][] {{0, 1, 2}}).normalZ(0));
    }

    @Test
    @DisplayName("the caller's array is kept")
    void laterWritesDoNotReachTheMesh() {
        double[] xyz = SQUARE.clone();
        int[][] faces = {{0, 1, 2, 3}};
        var mesh = new Mesh(xyz, faces);
        xyz[3] = 99;
        faces[0][1] = 3;
        assertEquals(4, mesh.x(1));
        assertEquals(1, mesh.corner(0, 1));
    }
}
