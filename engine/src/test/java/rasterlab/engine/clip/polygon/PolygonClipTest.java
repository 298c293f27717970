package rasterlab.engine.clip.polygon;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class PolygonClipTest {
    private static final boolean FULL = Boolean.getBoolean("rasterlab.full");
    private static final double MOST = Double.MAX_VALUE;
    private static final double[] TEN = PolygonInWindow.rectangle(0, 0, 10, 10);

    @Test
    void course5BarsJoinedOutsideStayBridgedBySutherlandHodgmanOnly() {
        double[] bars = {2, 2, 14, 2, 14, 8, 2, 8, 2, 7, 13, 7, 13, 3, 2, 3};
        assertEquals(1, PolygonCases.clip("sutherland-hodgman", TEN, bars).size());
        List<double[]> pieces = PolygonCases.clip("weiler-atherton", TEN, bars);
        assertEquals(2, pieces.size());
        for (double[] piece : pieces) assertEquals(8, PolygonArea.of(piece));
    }

    @ParameterizedTest
    @ValueSource(strings = {"sutherland-hodgman", "weiler-atherton"})
    void course5TheTriangleOverACornerLosesThatCorner(String method) {
        // (5, 5)→(15, 8) meets x = 10 at y = 6.5, (8, 15)→(5, 5) meets y = 10 at x = 6.5
        double[] piece = PolygonCases.clip(method, TEN, 5, 5, 15, 8, 8, 15).get(0);
        assertEquals(4, piece.length / 2, Arrays.toString(piece));
        assertEquals(25 - 2 * 3.75, PolygonArea.of(piece), 1e-12);
    }

    @Test
    void testsAndDivisionsOfTheTriangleOverACornerAreCounted() {
        // 3 corners at the bottom, 3 at the right, which leaves 4, 4 at the top, 4 at the left
        assertEquals(14, counted("sutherland-hodgman", "side tests"));
        assertEquals(4, counted("sutherland-hodgman", "divisions"));
        assertEquals(0, counted("weiler-atherton", "divisions"));
        // right and top by the edges from (5, 5) and to it, and by the one outside
        assertEquals(4, counted("weiler-atherton", "unrounded crossings"));
        assertTrue(counted("weiler-atherton", "side tests") <= 2 * 3 * 4 + 3 * 4);
    }

    private static long counted(String method, String what) {
        var input = new PolygonInWindow(TEN, new double[] {5, 5, 15, 8, 8, 15});
        var topic = PolygonCases.TOPIC;
        return topic.operations(topic.method(method).implementation(), input).get(what);
    }

    @Test
    void aNotchThatTouchesFromInsideLeavesTheRimOnBothSides() {
        // a hollow corner at (10, 5): both pieces meet there and are not joined
        var pieces =
                PolygonCases.clip(
                        "weiler-atherton",
                        TEN,
                        -2,
                        -2,
                        12,
                        -2,
                        12,
                        12,
                        5,
                        12,
                        10,
                        5,
                        5,
                        11,
                        -2,
                        11);
        assertEquals(2, pieces.size());
    }

    @Test
    void aSubjectThatTouchesTheRimAllTheWayIsItself() {
        double[] diamond = {5, 0, 10, 5, 5, 10, 0, 5};
        assertArrayEquals(sorted(diamond), sorted(onePiece("weiler-atherton", diamond)));
        assertArrayEquals(sorted(diamond), sorted(onePiece("sutherland-hodgman", diamond)));
    }

    private static double[] onePiece(String method, double[] subject) {
        List<double[]> pieces = PolygonCases.clip(method, TEN, subject);
        assertEquals(1, pieces.size());
        return pieces.get(0);
    }

    private static double[] sorted(double[] xy) {
        double[] sorted = xy.clone();
        Arrays.sort(sorted);
        return sorted;
    }

    @Test
    @Tag("slow")
    void everyTriangleOnASmallGridIsRight() {
        double[] window = PolygonInWindow.rectangle(1, 1, 3, 3);
        IntStream.range(0, 15_625)
                .parallel()
                .forEach(
                        i -> {
                            double[] xy = new double[6];
                            for (int k = 0, rest = i; k < 6; k++, rest /= 5) xy[k] = rest % 5;
                            if (PolygonCases.proper(window, xy))
                                PolygonCases.assertRight(window, xy);
                        });
    }

    @Test
    void everySimplePolygonDrawnOnAGridIsRight() {
        double[][] windows = {
            PolygonInWindow.rectangle(2, 2, 4, 5),
            {3, 1, 5, 3, 3, 5, 1, 3},
            {1, 1, 5, 2, 6, 6, 2, 5}
        };
        IntStream.range(0, FULL ? 1_000_000 : 6_000)
                .parallel()
                .forEach(
                        seed -> {
                            var random = new Random(seed);
                            double[] window = windows[seed % 3];
                            double[] subject = PolygonCases.onGrid(random, 4 + random.nextInt(6));
                            if (PolygonCases.proper(window, subject))
                                PolygonCases.assertRight(window, subject);
                        });
    }

    @Test
    void starsInConvexWindowsAreRight() {
        IntStream.range(0, FULL ? 20_000 : 60)
                .parallel()
                .forEach(
                        seed -> {
                            var random = new Random(seed);
                            PolygonCases.assertRight(
                                    PolygonCases.convexWindow(random),
                                    PolygonClipWorkloads.star(3 + random.nextInt(30), random));
                        });
    }

    static Stream<Arguments> refused() {
        double[] proper = {2, 2, 8, 3, 5, 8};
        return Stream.of(
                Arguments.of(TEN, new double[] {}, "polygon must have from 3"),
                Arguments.of(TEN, new double[] {5, 5}, "different corners, got 1"),
                Arguments.of(TEN, new double[] {1, 1, 1, 1, 2, 2}, "different corners, got 2"),
                Arguments.of(TEN, new double[] {1, 2, 3}, "got 3 numbers"),
                Arguments.of(TEN, new double[] {1, 1, 2, 2, 3, 3}, "polygon must be simple"),
                Arguments.of(
                        TEN, new double[] {1, 1, 9, 9, 9, 1, 1, 9}, "(1.0, 1.0) and (9.0, 1.0)"),
                Arguments.of(TEN, new double[] {1, 1, 9, 1, 1, 1, 5, 5}, "is there twice"),
                Arguments.of(
                        TEN,
                        new double[] {-0.0, 1, 5, 5, 0, 1, -5, 5},
                        "corner (0.0, 1.0) is there twice"),
                Arguments.of(TEN, new double[] {1, 1, 9, 1, 5, 1, 5, 5}, "meet"),
                Arguments.of(
                        TEN,
                        new double[] {1, 1, 9, Double.NaN, 5, 5},
                        "polygon corner 1 must be finite, got (9.0, NaN)"),
                Arguments.of(
                        new double[] {0, 0, 1, 0, 1, Double.POSITIVE_INFINITY},
                        proper,
                        "window corner 2 must be finite, got (1.0, Infinity)"),
                Arguments.of(new double[] {0, 0, 1, 1, 2, 2}, proper, "an area above 0"),
                Arguments.of(
                        new double[] {0, 0, 4, 0, 1, 1, 0, 4}, proper, "its corner (1.0, 1.0)"),
                Arguments.of(
                        new double[] {0, 0, 10, 0, 5, 0, 5, 5},
                        proper,
                        "turns back at its corner (10.0, 0.0)"),
                Arguments.of(
                        new double[] {0, 3, -2, -3, 3, 1, -3, 1, 2, -3},
                        proper,
                        "goes round 2 times"));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void whatIsNoPolygonOrNoConvexWindowIsRefusedByPlace(
            double[] window, double[] subject, String part) {
        for (String method : List.of("sutherland-hodgman", "weiler-atherton")) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> PolygonCases.clip(method, window, subject));
            assertTrue(refusal.getMessage().contains(part), refusal.getMessage());
        }
    }

    /** Spikes, loops, stars and lines among them. */
    @Test
    @Tag("slow")
    void aWindowIsAcceptedIfAndOnlyIfItIsConvex() {
        double[] subject = {1, 1, 5, 2, 3, 6};
        var random = new Random(6);
        int proper = 0;
        for (int i = 0; i < 40_000; i++)
            if (PolygonCases.proper(PolygonCases.onGrid(random, 3 + i % 4), subject)) proper++;
        assertTrue(proper > 1_000, proper + " proper windows");
    }

    @Test
    @Tag("slow")
    void aHundredThousandCornersAreNoHang() {
        double[] star = PolygonClipWorkloads.star(FULL ? 1_000_000 : 100_000, new Random(1));
        double[] window = PolygonInWindow.rectangle(0, 0, 100, 100);
        double bridged = areaInTime("sutherland-hodgman", window, star);
        double separate = areaInTime("weiler-atherton", window, star);
        assertEquals(separate, bridged, PolygonClipTopic.RIGHT_SHARE * 100 * 100);
        assertTrue(separate > 1_000, "area " + separate);
    }

    private static double areaInTime(String method, double[] window, double[] subject) {
        List<double[]> pieces =
                assertTimeoutPreemptively(
                        Duration.ofMinutes(5), () -> PolygonCases.clip(method, window, subject));
        return pieces.stream().mapToDouble(PolygonArea::of).sum();
    }

    static Stream<Arguments> extremeWindows() {
        double huge = 1e200;
        double tiny = 1e-170;
        return Stream.of(
                argumentSet(
                        "areas beyond the largest double",
                        PolygonInWindow.rectangle(0, 0, huge, huge),
                        new double[] {
                            0.1 * huge, 0.1 * huge, 0.9 * huge, 0.1 * huge, 0.5 * huge, 0.9 * huge
                        }),
                argumentSet(
                        "areas below the smallest double",
                        PolygonInWindow.rectangle(0, 0, tiny, tiny),
                        new double[] {
                            0.1 * tiny, 0.1 * tiny, 2 * tiny, 0.1 * tiny, 0.5 * tiny, 0.9 * tiny
                        }),
                argumentSet(
                        "wide beyond doubles and as low",
                        PolygonInWindow.rectangle(0, 0, huge, tiny),
                        new double[] {0, 0, 2 * huge, 0, huge, 3 * tiny}),
                argumentSet(
                        "the largest window",
                        PolygonInWindow.rectangle(-MOST, -MOST, MOST, MOST),
                        new double[] {-MOST, -MOST, MOST, -1, 0, MOST}),
                argumentSet(
                        "a sliver wholly inside",
                        PolygonInWindow.rectangle(-1, -1, 11, 11),
                        new double[] {0, 0, 10, 10, 5, 5 + 1e-13}),
                argumentSet(
                        "a sliver cut at both ends",
                        PolygonInWindow.rectangle(1, 1, 9, 9),
                        new double[] {0, 0, 10, 10, 5, 5 + 1e-13}),
                argumentSet(
                        "a speck in a large window",
                        PolygonInWindow.rectangle(0, 0, huge, huge),
                        new double[] {0, 0, tiny, 0, 0, tiny}));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("extremeWindows")
    void noPieceIsLostWhereItsAreaIsNoOrdinaryDouble(double[] window, double[] subject) {
        for (String method : List.of("sutherland-hodgman", "weiler-atherton"))
            assertEquals(1, PolygonCases.clip(method, window, subject).size(), method);
        PolygonCases.assertRight(window, subject);
    }

    /** An edge passes exactly through (0, 0), which a rounded crossing makes a triangle. */
    @Test
    void aTouchedCornerLeavesNothingHoweverTheCrossingIsRounded() {
        for (int before = 1; before < 40; before++)
            for (int behind = 1; behind < 40; behind++) {
                double[] subject = {-7 * before, 3 * before, -300, -300, 7 * behind, -3 * behind};
                var pieces = PolygonCases.clip("sutherland-hodgman", TEN, subject);
                assertEquals(0, pieces.size(), () -> Arrays.toString(subject));
            }
    }

    @Test
    void largestDoublesAreRight() {
        double most = Double.MAX_VALUE;
        PolygonCases.assertRight(TEN, -most, -most, most, -most, most, most, -most, most);
        PolygonCases.assertRight(TEN, -most, -most, most, -most, 5, most);
    }

    @Test
    void weilerAthertonTellsWhereTheBoundaryEntersAndLeaves() {
        double[] bar = {-4, 2, 14, 2, 14, 8, -4, 8};
        PolygonWalk walk = new WeilerAtherton().walk(TEN, bar);
        assertEquals(0, walk.passage().length, "before the first step");
        assertTrue(walk.advance());
        assertArrayEquals(new double[] {0, 2, 10, 2}, walk.passage());
        assertTrue(walk.advance());
        assertArrayEquals(new double[] {10, 8, 0, 8}, walk.passage());
        assertEquals(0, new SutherlandHodgman().walk(TEN, bar).passage().length);
    }

    @Test
    void ringKeepsItsCornersWhereTheirArrayChanges() {
        double[] corners = {0, 0, 4, 0, 0, 3};
        var ring = new Ring(corners);
        corners[2] = 9;
        assertEquals(4, ring.x(1));
    }
}
