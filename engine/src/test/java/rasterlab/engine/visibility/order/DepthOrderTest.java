package rasterlab.engine.visibility.order;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import rasterlab.contract.DepthOrder;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.order.OrderStep.OrderStepKind;

class DepthOrderTest {
    private static final DepthOrderTopic TOPIC = new DepthOrderTopic();
    private static final double[] EYE = {0, 0, 0};
    private static final double[] NEAR = {-1, -1, 5, 1, -1, 5, 0, 1, 5};
    private static final double[] FAR = {-1, -1, 9, 1, -1, 9, 0, 1, 9};

    private static Sight hazard(String name) {
        return TOPIC.hazards().stream()
                .filter(hazard -> hazard.name().equals(name))
                .findFirst()
                .orElseThrow()
                .input();
    }

    private static Painting painted(String method, Sight sight) {
        return TOPIC.record(TOPIC.method(method).implementation(), sight, 100_000);
    }

    private static List<Integer> order(Painting painting) {
        return painting.pieces().stream().map(Painting.Piece::polygon).toList();
    }

    @Test
    void everyMethodPaintsTheFartherFirst() {
        for (Method<?> method : TOPIC.methods())
            assertEquals(
                    List.of(1, 0),
                    order(painted(method.name(), new Sight(new double[][] {NEAR, FAR}, EYE))),
                    method.name());
    }

    @Test
    void wholePolygonsKeepTheirCorners() {
        for (Method<?> method : TOPIC.methods())
            assertArrayEquals(
                    FAR,
                    painted(method.name(), new Sight(new double[][] {NEAR, FAR}, EYE))
                            .pieces()
                            .get(0)
                            .corners());
    }

    @Test
    void newellMovesMarksAndCutsACircle() {
        var newell = (SteppedOrder) TOPIC.method("newell").implementation();
        OrderWalk walk = newell.walk(hazard("circle-of-three"), (polygon, corners) -> {});
        var kinds = new ArrayList<OrderStepKind>();
        while (walk.advance()) kinds.add(walk.step().kind());
        assertEquals(List.of(OrderStepKind.MOVE, OrderStepKind.CUT), kinds.subList(0, 2));
        long cuts = kinds.stream().filter(kind -> kind == OrderStepKind.CUT).count();
        assertEquals(cuts, walk.operations().get("splits"));
        assertEquals(3 + cuts, kinds.stream().filter(kind -> kind == OrderStepKind.PAINT).count());
    }

    @Test
    void nothingIsCutThatCanBeOrderedWhole() {
        assertEquals(3, painted("newell", hazard("one-behind-the-other")).size());
        assertEquals(2, painted("newell", hazard("mean-mis-sorts")).size());
        assertEquals(2, painted("newell", hazard("coplanar")).size());
    }

    @Test
    void crossingSquaresAreCutOnce() {
        assertEquals(3, painted("newell", hazard("through-each-other")).size());
        assertEquals(3, painted("bsp", hazard("through-each-other")).size());
    }

    /** A polygon that waited for one of a circle still waits when that one is cut. */
    @Test
    void cutLeavesAloneWhatWaited() {
        OrderWalk walk = new Newell().walk(everyOneThroughTheOthers(60), (polygon, corners) -> {});
        long steps = 0;
        while (walk.advance()) steps++;
        long splits = walk.operations().get("splits");
        assertTrue(steps < 6 * splits, steps + " steps, " + splits + " cuts");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("endless")
    void newellGivesUp(Newell method, String complaint) {
        OrderWalk walk = method.walk(everyOneThroughTheOthers(60), (polygon, corners) -> {});
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> {
                            while (walk.advance()) {}
                        });
        assertEquals(complaint, refusal.getMessage());
    }

    static Stream<Arguments> endless() {
        return Stream.of(
                argumentSet(
                        "cuts fill the memory",
                        new Newell(200, 100_000_000),
                        "60 polygons must need at most 200 pieces, got 201 with 155 pieces left to paint"),
                argumentSet(
                        "comparisons never end",
                        new Newell(1_000_000, 10_000),
                        "60 polygons must need at most 10000 comparisons, got 10087 with 161 pieces left to paint"));
    }

    /** Each of the same random triangles in every run meets most others. */
    static Sight everyOneThroughTheOthers(int count) {
        var random = new Random(1972);
        var triangles = new double[count][];
        for (int k = 0; k < count; k++) triangles[k] = random.doubles(9, -100, 100).toArray();
        return new Sight(triangles, new double[] {300, -400, 350});
    }

    /** n² against n·log n: 64 times the polygons cost 4,000 times as much, or some 150 times. */
    @Test
    void comparisonsOfTheTextbookGrowWithTheSquare() {
        assertTrue(growth("mean-z-textbook") > 3_000, "" + growth("mean-z-textbook"));
        assertTrue(growth("mean-z") < 300, "" + growth("mean-z"));
        assertTrue(growth("newell") < 3_000, "" + growth("newell"));
        assertTrue(growth("bsp") < 600, "" + growth("bsp"));
    }

    private static double growth(String name) {
        DepthOrder method = TOPIC.method(name).implementation();
        var workloads = TOPIC.workloads();
        var least = workloads.get(0).inputs().get(0);
        var most = workloads.get(workloads.size() - 1).inputs().get(0);
        return (double) TOPIC.operations(method, most).get("comparisons")
                / TOPIC.operations(method, least).get("comparisons");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("wrongPaintings")
    void comparisonSees(Sight sight, Painting painting, String first) {
        Deviation deviation = PaintingComparison.compare(sight, painting);
        assertEquals(first, deviation.first());
        assertFalse(TOPIC.correct(deviation));
    }

    static Stream<Arguments> wrongPaintings() {
        var two = new Sight(new double[][] {NEAR, FAR}, EYE);
        var half = new double[] {-1, -1, 5, 0, -1, 5, 0, 1, 5};
        var rest = new double[] {0, -1, 5, 1, -1, 5, 0, 1, 5};
        return Stream.of(
                argumentSet(
                        "farther over nearer passes",
                        two,
                        painting(0, NEAR, 1, FAR),
                        "polygon 1 is painted over polygon 0, which is nearer"),
                argumentSet(
                        "polygon is left out", two, painting(1, FAR), "polygon 0 is not painted"),
                argumentSet(
                        "half a polygon is a whole one",
                        two,
                        painting(1, FAR, 0, half),
                        "the pieces of polygon 0 do not cover it once"),
                argumentSet(
                        "pieces that overlap cover",
                        two,
                        painting(1, FAR, 0, half, 0, half),
                        "the pieces of polygon 0 do not cover it once"),
                argumentSet(
                        "piece is another place",
                        two,
                        painting(1, FAR, 0, half, 0, new double[] {0, -1, 5, 2, -1, 5, 0, 0, 5}),
                        "a piece of polygon 0 reaches out of it"),
                argumentSet(
                        "piece is painted too early",
                        two,
                        painting(0, half, 1, FAR, 0, rest),
                        "polygon 1 is painted over polygon 0, which is nearer"),
                argumentSet(
                        "polygon that there is not passes",
                        two,
                        painting(1, FAR, 0, NEAR, 2, NEAR),
                        "there is no polygon 2"));
    }

    private static Painting painting(Object... pieces) {
        var painting = new Painting();
        for (int i = 0; i < pieces.length; i += 2)
            painting.add((Integer) pieces[i], (double[]) pieces[i + 1]);
        return painting;
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("outOfRange")
    void everyMethodRefusesOutOfRange(double[] polygon, String message) {
        var sight = new Sight(new double[][] {NEAR, polygon}, EYE);
        for (Method<DepthOrder> method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> TOPIC.record(method.implementation(), sight, 100),
                            method.name());
            assertEquals(message, refusal.getMessage(), method.name());
        }
    }

    static Stream<Arguments> outOfRange() {
        return Stream.of(
                argumentSet(
                        "strip is too narrow",
                        new double[] {-5e5, 0, 9, 5e5, 0, 9, 5e5, 0.25, 9, -5e5, 0.25, 9},
                        "polygon 1 must be at least 0.5 wide, 10⁻⁶ of the largest coordinate"
                                + " 500000.0, got 0.2499999999999922"),
                argumentSet(
                        "wall is too near before the eye",
                        new double[] {-5e5, -8, 0.25, 5e5, -8, 0.25, 0, 9, 0.25},
                        "polygon 1 must be at least 0.5 from the eye, 10⁻⁶ of the largest"
                                + " coordinate 500000.0, got 0.25"),
                argumentSet(
                        "corner is too near beside the eye",
                        new double[] {0.25, 0, 0, 5e5, 5e5, 0, 5e5, -5e5, 7},
                        "polygon 1 must be at least 0.5 from the eye, 10⁻⁶ of the largest"
                                + " coordinate 500000.0, got 0.25"));
    }

    @Test
    void nothingIsPaintedWhereThereIsNothing() {
        for (Method<?> method : TOPIC.methods())
            assertEquals(
                    List.of(),
                    order(painted(method.name(), new Sight(new double[0][], EYE))),
                    method.name());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("badInput")
    void everyMethodRefuses(double[] polygon, double[] eye, String message) {
        for (Method<DepthOrder> method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () ->
                                    method.implementation()
                                            .order(
                                                    new double[][] {NEAR, polygon},
                                                    eye,
                                                    (number, corners) -> {}),
                            method.name());
            assertEquals(message, refusal.getMessage(), method.name());
        }
    }

    static Stream<Arguments> badInput() {
        return Stream.of(
                argumentSet(
                        "NaN is a coordinate",
                        new double[] {0, 0, 5, 1, Double.NaN, 5, 0, 1, 5},
                        EYE,
                        "polygon 1, corner 1: y must be finite, got NaN"),
                argumentSet(
                        "infinity is an eye",
                        FAR,
                        new double[] {0, Double.NEGATIVE_INFINITY, 0},
                        "eye coordinate 1 must be finite, got -Infinity"),
                argumentSet(
                        "eye lacks a number",
                        FAR,
                        new double[] {0, 0},
                        "eye needs 3 numbers, got [0.0, 0.0]"),
                argumentSet(
                        "two corners are a polygon",
                        new double[] {0, 0, 5, 1, 0, 5},
                        EYE,
                        "polygon 1 needs at least 3 corners of 3 numbers each, got 6 numbers"),
                argumentSet(
                        "polygon without area is painted",
                        new double[] {0, 0, 5, 1, 1, 5, 2, 2, 5},
                        EYE,
                        "polygon 1: corners [0, 1, 2] span no area"),
                argumentSet(
                        "bent polygon is painted",
                        new double[] {0, 0, 5, 1, 0, 5, 1, 1, 6, 0, 1, 5},
                        EYE,
                        "polygon 1: corner 1 lies off the plane of the others"),
                argumentSet(
                        "polygon that is not convex is painted",
                        new double[] {0, 0, 5, 4, 0, 5, 1, 1, 5, 0, 4, 5},
                        EYE,
                        "polygon 1: corner 2 turns inwards, faces must be convex"));
    }
}
