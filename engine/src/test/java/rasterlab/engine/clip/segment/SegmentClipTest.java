package rasterlab.engine.clip.segment;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Workload;

class SegmentClipTest {
    private static final SegmentClipTopic TOPIC = new SegmentClipTopic();
    private static final ClipWindow TEN = new ClipWindow(0, 0, 10, 10);

    static Stream<Method<SegmentClipper>> right() {
        return SegmentCases.rightMethods().stream();
    }

    private static double[] clipped(String method, double... ends) {
        return SegmentCases.clip(TOPIC.method(method).implementation(), TEN, ends).orElseThrow();
    }

    @ParameterizedTest
    @MethodSource("right")
    void course5CrossingByTheParametricFormula(Method<SegmentClipper> method) {
        // x = 10 at t = (10 − 5)/(15 − 5) = 1/2, y = 2 + 1/2·(8 − 2) = 5
        assertArrayEquals(
                new double[] {5, 2, 10, 5}, clipped(method.name(), 5, 2, 15, 8), 1e-14, "right");
    }

    @Test
    void course5ErratumASegmentWhollyOutsideIsDrawn() {
        assertArrayEquals(
                new double[] {-5, 2, -1, 8}, clipped("cohen-sutherland-textbook", -5, 2, -1, 8));
    }

    @Test
    void course5ErratumTheQuotientOfWholeNumbersIsNothing() {
        // the slope 5/13 is 0 in whole numbers, so the end (15, 8) is moved to (10, 8)
        assertArrayEquals(
                new double[] {2, 3, 10, 8}, clipped("cohen-sutherland-textbook", 2, 3, 15, 8));
    }

    @Test
    void course5ErratumXStandsForYBelowAndToTheLeft() {
        // y1 ← x1 + …: (−2, −3) goes to y = −2 + (12 + 3)·2/10 = 1 at x = 0, not to −3 + 3 = 0
        assertEquals(1, clipped("cohen-sutherland-nested-textbook", -2, -3, 8, 12)[1]);
    }

    @Test
    void course5ErratumTheWindowsTopStandsForItsRightSide() {
        // (26, −4) goes to y = 26 + (1 + 4)·(10 − 26)/(8 − 26) = 274/9 at x = 20, then to y = 10 at
        // x = 20 + (8 − 20)·(10 − 274/9)/(1 − 274/9) = 3092/265; with xmax for ymax it is 12.05
        var window = new ClipWindow(0, 0, 20, 10);
        var nested = TOPIC.method("cohen-sutherland-nested-textbook").implementation();
        assertArrayEquals(
                new double[] {8, 1, 3092 / 265.0, 10},
                SegmentCases.clip(nested, window, 8, 1, 26, -4).orElseThrow(),
                1e-12);
    }

    @Test
    void course5ARoundedSlopeKeepsAnEndOutsideForEver() {
        var walk =
                SegmentClipTopic.walk(
                        new CohenSutherlandFloatTextbook(), TEN, new double[] {-5, 21, 10, 10});
        for (int i = 0; i < 10_000; i++) assertTrue(walk.advance());
    }

    @Test
    void course5ErratumTheNestedTestNeverMovesAnEndThatIsOnlyLeft() {
        var walk =
                SegmentClipTopic.walk(
                        new CohenSutherlandNestedTextbook(), TEN, new double[] {-5, 5, 5, 5});
        for (int i = 0; i < 10_000; i++) assertTrue(walk.advance());
    }

    static Stream<Arguments> refused() {
        var bad = new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        var names =
                List.of(
                        "xmin",
                        "ymin",
                        "xmax",
                        "ymax",
                        "x of end 0",
                        "y of end 0",
                        "x of end 1",
                        "y of end 1");
        var cases = new ArrayList<Arguments>();
        for (var method : SegmentCases.rightMethods())
            for (int i = 0; i < names.size(); i++)
                for (double value : bad) {
                    double[] numbers = {0, 0, 10, 10, 1, 2, 3, 4};
                    numbers[i] = value;
                    cases.add(Arguments.of(method, numbers, names.get(i), String.valueOf(value)));
                }
        return cases.stream();
    }

    @ParameterizedTest
    @MethodSource("refused")
    void everyNumberThatIsNotFiniteIsRefusedByName(
            Method<SegmentClipper> method, double[] n, String name, String value) {
        assertRefused(method, n, name, value);
    }

    @ParameterizedTest
    @MethodSource("right")
    void sidesInTheWrongOrderAreRefusedWhereverTheSegmentLies(Method<SegmentClipper> method) {
        assertRefused(method, new double[] {3, 0, 2, 10, 1, 2, 3, 4}, "xmin", "3.0 > 2.0");
        assertRefused(method, new double[] {0, 7, 10, 5, 50, 2, 30, 4}, "ymin", "7.0 > 5.0");
    }

    private static void assertRefused(
            Method<SegmentClipper> method, double[] n, String name, String value) {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                method.implementation()
                                        .clip(
                                                n[0],
                                                n[1],
                                                n[2],
                                                n[3],
                                                n[4],
                                                n[5],
                                                n[6],
                                                n[7],
                                                (x0, y0, x1, y1) -> {}));
        assertTrue(refusal.getMessage().contains(name), refusal.getMessage());
        assertTrue(refusal.getMessage().contains(value), refusal.getMessage());
    }

    @Test
    void cohenSutherlandMakesAtMostFourCuts() {
        var method = new CohenSutherland();
        var random = new Random(4);
        for (int i = 0; i < 50_000; i++) {
            ClipWindow window = SegmentCases.randomWindow(random);
            double[] ends =
                    i % 2 == 0
                            ? SegmentCases.randomSegment(random, window)
                            : SegmentCases.adversary(random, window);
            SegmentWalk walk = SegmentClipTopic.walk(method, window, ends);
            int cuts = 0;
            while (walk.advance()) cuts++;
            assertTrue(cuts <= 4, cuts + " cuts");
        }
    }

    @ParameterizedTest
    @MethodSource("right")
    void steppingLeavesWhatClippingLeaves(Method<SegmentClipper> method) {
        var stepped = (SteppedSegmentClipper) method.implementation();
        var random = new Random(5);
        for (int i = 0; i < 2_000; i++) {
            ClipWindow window = SegmentCases.randomWindow(random);
            double[] ends = SegmentCases.randomSegment(random, window);
            SegmentWalk walk = SegmentClipTopic.walk(stepped, window, ends);
            while (walk.advance()) assertTrue(!walk.at().isEmpty());
            var capture = new PartCapture(10);
            walk.send(capture);
            capture.next();
            Optional<double[]> walked = capture.captured().parts().get(0);
            Optional<double[]> clipped = SegmentCases.clip(stepped, window, ends);
            assertEquals(clipped.isPresent(), walked.isPresent());
            if (walked.isPresent()) assertArrayEquals(clipped.get(), walked.get());
        }
    }

    @Test
    void aMethodThatSendsForEverIsStopped() {
        SegmentClipper endless =
                (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) -> {
                    while (true) out.segment(x0, y0, x1, y1);
                };
        var input = new SegmentsInWindow(TEN, List.of(new double[4]));
        assertThrows(LimitReached.class, () -> TOPIC.record(endless, input, 1_000));
    }

    @ParameterizedTest
    @MethodSource("right")
    void moreSegmentsThanTheLimitAreLeftOutButThoseBeforeAreKept(Method<SegmentClipper> method) {
        var input = new SegmentsInWindow(TEN, Collections.nCopies(5, new double[] {1, 2, 3, 4}));
        var reached =
                assertThrows(
                        LimitReached.class, () -> TOPIC.record(method.implementation(), input, 3));
        assertEquals(3, ((ClippedEnds) reached.recorded()).kept());
    }

    @Test
    void everyWorkloadHasItsShareOfVisibleSegments() {
        for (Workload<SegmentsInWindow> workload : TOPIC.workloads())
            for (var input : workload.inputs())
                assertEquals(workload.size(), TOPIC.exact(input, 1_000).kept(), workload.name());
    }

    @Test
    void fourLinesAlwaysDividesAndCohenSutherlandOnlyToCut() {
        var input = TOPIC.workloads().get(4).inputs().get(0);
        long lines = divisions("four-lines", input);
        assertEquals(400, lines);
        assertTrue(divisions("cohen-sutherland", input) < lines / 2);
    }

    private static long divisions(String method, SegmentsInWindow input) {
        return TOPIC.operations(TOPIC.method(method).implementation(), input).get("divisions");
    }

    /** A cut by one side may leave ends beyond another, which is tested later. */
    @ParameterizedTest
    @MethodSource("right")
    void whatAStepLeavesIsAPartOfTheSegment(Method<SegmentClipper> method) {
        double[] ends = {-3, -1.5, 12, 8};
        var window = new ClipWindow(0, 0, 10, 6);
        var stepped = (SteppedSegmentClipper) method.implementation();
        SegmentWalk walk = SegmentClipTopic.walk(stepped, window, ends);
        while (walk.advance())
            walk.piece(
                    (x0, y0, x1, y1) -> {
                        assertEquals(0, (x0 + 3) * 9.5 - (y0 + 1.5) * 15, 1e-9, walk.at());
                        assertEquals(0, (x1 + 3) * 9.5 - (y1 + 1.5) * 15, 1e-9, walk.at());
                    });
    }
}
