package rasterlab.engine.polygon.triangulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.StarPolygon;

class TriangulationInputTest {
    private static final double NAN = Double.NaN;
    private static final double INF = Double.POSITIVE_INFINITY;
    private static final String MEET = "edges may meet only at the corner they share, but those";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesWithPlaceAndValue(double[] x, double[] y, String message) {
        for (var method : new SteppedTriangulator[] {new EarClipping(), new ShortestDiagonal()}) {
            var refusal =
                    assertThrows(IllegalArgumentException.class, () -> method.triangulate(x, y));
            assertEquals(message, refusal.getMessage());
        }
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "no corner at all becomes no triangle",
                        of(),
                        of(),
                        "at least 3 corners are needed, got 0"),
                argumentSet(
                        "one point becomes a triangle",
                        of(1),
                        of(1),
                        "at least 3 corners are needed, got 1"),
                argumentSet(
                        "NaN is compared as if it were a number",
                        of(0, 1, NAN),
                        of(0, 0, 1),
                        "corner 2 must be finite, got (NaN, 1.0)"),
                argumentSet(
                        "infinity reaches the products",
                        of(0, 1, 1),
                        of(0, 0, INF),
                        "corner 2 must be finite, got (1.0, Infinity)"),
                argumentSet(
                        "missing coordinate is read beyond the array",
                        of(0, 1, 1),
                        of(0, 0),
                        "corners have 3 x but 2 y; give as many"),
                argumentSet(
                        "two places make a triangle",
                        of(0, 1, 1, 0),
                        of(0, 0, 0, 0),
                        "at least 3 different corners are needed, got 2"),
                argumentSet(
                        "bow tie is cut as if it had an inside",
                        of(0, 4, 0, 4),
                        of(0, 4, 4, 0),
                        MEET + " from corners 0 and 2 meet elsewhere"),
                argumentSet(
                        "corner that touches a far edge is passed over",
                        of(0, 8, 8, 4, 0),
                        of(0, 0, 6, 0, 6),
                        MEET + " from corners 0 and 3 meet elsewhere"),
                argumentSet(
                        "two corners in one place hide each other",
                        of(0, 4, 2, 4, 0, 2),
                        of(0, 0, 2, 4, 4, 2),
                        MEET + " from corners 2 and 5 meet elsewhere"),
                argumentSet(
                        "edge that goes back along its neighbour",
                        of(0, 8, 4, 4),
                        of(0, 0, 0, 4),
                        MEET + " from corners 0 and 1 meet elsewhere"),
                argumentSet(
                        "hole on a bridge is gone round as the outside is",
                        of(0, 6, 6, 0, 0, 2, 4, 4, 2, 2),
                        of(0, 0, 6, 6, 0, 2, 2, 4, 4, 2),
                        "holes must lie inside and be gone round the other way than the outside, but"
                                + " those round corner 5 are not"),
                argumentSet(
                        "bridges alone are a polygon",
                        of(0, 4, 4, 4),
                        of(0, 0, 3, 0),
                        "all edges are gone along both ways: no area"));
    }

    @Test
    void aMillionCornersAreRefusedByTheNumber() {
        Points polygon = StarPolygon.of(1_000_000, 1, new Random(1));
        for (String name : new String[] {"shortest-diagonal-textbook", "shortest-diagonal"})
            assertRefusesCount(name, polygon);
    }

    private static void assertRefusesCount(String name, Points polygon) {
        var method = new TriangulateTopic().method(name).implementation();
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> method.triangulate(polygon.xs(), polygon.ys()));
        assertTrue(
                refusal.getMessage().endsWith("corners are taken, got 1000000"),
                refusal.getMessage());
    }

    /** Steps are told as the corner cut off and the diagonal a–c. */
    @Test
    void fanCutsOffTheMiddleCornerWhicheverWayRound() {
        assertEquals(List.of("0 1 2", "0 2 3"), steps(new Fan(), of(0, 4, 4, 0), of(0, 0, 4, 4)));
        assertEquals(List.of("2 1 0", "3 2 0"), steps(new Fan(), of(0, 4, 4, 0), of(4, 4, 0, 0)));
    }

    @Test
    void fanCostsThreeTurnsPerCornerLessThree() {
        var walk = new Fan().walk(of(0, 4, 4, 0), of(0, 0, 4, 4));
        assertEquals(9, walk.turns());
    }

    private static List<String> steps(SteppedTriangulator method, double[] x, double[] y) {
        var steps = new ArrayList<String>();
        var walk = method.walk(x, y);
        while (walk.advance()) steps.add(walk.a() + " " + walk.b() + " " + walk.c());
        return steps;
    }

    @Test
    void repeatedCornersKeepTheirFirstNumbers() {
        int[] triples = new EarClipping().triangulate(of(0, 0, 4, 4, 0, 0), of(0, 0, 0, 4, 4, 0));
        assertEquals(6, triples.length);
        for (int corner : triples) assertTrue(corner != 1 && corner != 5, "corner " + corner);
    }

    private static double[] of(double... values) {
        return values;
    }
}
