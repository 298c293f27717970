package rasterlab.engine.visibility.faces;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.study.Method;

class VisibleFacesTest {
    private static final VisibleFacesTopic TOPIC = new VisibleFacesTopic();
    private static final double[] NONE = {};
    private static final double[] EYE = {1, 2, 3};
    private static final double[] TRIANGLE = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    private static final int[][] ONE_FACE = {{0, 1, 2}};

    private static boolean[] visible(String method, Body body) {
        VisibleFaces implementation = TOPIC.method(method).implementation();
        return implementation.visible(body.xyz(), body.faces(), body.eye(), body.inside());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void everyMethodJudges(Body body, List<Integer> seen) {
        var wanted = new boolean[body.faceCount()];
        for (int face : seen) wanted[face] = true;
        for (Method<?> method : TOPIC.methods())
            assertArrayEquals(wanted, visible(method.name(), body), method.name());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("back faces are seen", Bodies.cube(5, -6, 7), List.of(1, 2, 3)),
                argumentSet("side is taken for the opposite", Bodies.cube(0, 0, -9), List.of(0)),
                argumentSet("edge-on face is seen", Bodies.cube(1, -9, 1), List.of(2)),
                argumentSet("inside is outside", Bodies.cube(0, 0.5, 0), List.of()),
                argumentSet(
                        "normal of a pole's triangle points inwards",
                        Bodies.sphere(4, 2, 1, 5, 5, 6),
                        List.of(0, 1, 3, 4)));
    }

    @Property(tries = 300)
    void everyMethodFindsTheFacesOfASphereThatTheReferenceFinds(
            @ForAll @IntRange(min = 3, max = 12) int meridians,
            @ForAll @IntRange(min = 2, max = 9) int parallels,
            @ForAll long seed) {
        var random = new Random(seed);
        var eye = new double[3];
        for (int axis = 0; axis < 3; axis++) eye[axis] = random.nextDouble(-9, 9);
        Body body = Bodies.sphere(meridians, parallels, 2, eye).withInside(0, 0, 0);
        SeenFaces exact = TOPIC.exact(body, Integer.MAX_VALUE);
        for (String method : List.of("back-face", "convex-segment"))
            assertEquals("", exact.deviation(new SeenFaces(visible(method, body))).first(), method);
    }

    /** Many eyes lie in planes of faces on a small grid, and many faces have no area. */
    @Property(tries = 2_000)
    void noSignIsLostToRounding(@ForAll long seed, @ForAll @IntRange(max = 40) int exponent) {
        var random = new Random(seed);
        var xyz = random.ints(15, -3, 4).mapToDouble(v -> v * 0.1).toArray();
        var eye = random.ints(3, -3, 4).mapToDouble(v -> v * 0.1).toArray();
        var body = Body.seenFrom(eye, xyz, new int[] {0, 1, 2, 3, 4}, new int[] {4, 2, 0});
        Body scaled = body.scaled(Math.scalb(1.0, -26 * exponent));
        SeenFaces exact = TOPIC.exact(scaled, Integer.MAX_VALUE);
        assertEquals("", exact.deviation(new SeenFaces(visible("back-face", scaled))).first());
    }

    @Property(tries = 300)
    void anotherInnerPointSeesNoOtherFaces(@ForAll long seed) {
        var random = new Random(seed);
        Body body = Bodies.cube(random.nextDouble(-4, 4), random.nextDouble(-4, 4), 3);
        boolean[] wanted = visible("back-face", body);
        double[] inside = random.doubles(3, -0.99, 0.99).toArray();
        assertArrayEquals(wanted, visible("convex-segment", body.withInside(inside)));
    }

    @Test
    void closerLookOnlyWhereRoundingCouldDecide() {
        var backFace = (SteppedVisibleFaces) TOPIC.method("back-face").implementation();
        assertEquals(
                0, TOPIC.operations(backFace, Bodies.cube(5, -6, 7)).get("sides asked exactly"));
        assertEquals(
                1, TOPIC.operations(backFace, Bodies.cube(5, -6, 1)).get("sides asked exactly"));
    }

    @Test
    void costGrowsWithTheFacesAndNotTheirSquare() {
        for (Method<VisibleFaces> method : TOPIC.methods())
            for (var workload : TOPIC.workloads()) {
                long done =
                        TOPIC
                                .operations(method.implementation(), workload.inputs().get(0))
                                .values()
                                .stream()
                                .mapToLong(Long::longValue)
                                .sum();
                assertTrue(done <= 3L * workload.size(), method.name() + " " + workload.name());
            }
    }

    @Test
    void millionFacesAreJudged() {
        Body body = Bodies.sphere(1_000, 1_000, 10, 0, 0, 1e9);
        boolean[] visible = visible("back-face", body);
        assertTrue(visible[0] && !visible[999_999]);
    }

    @Test
    void nothingIsSeenOfABodyWithoutFaces() {
        for (Method<VisibleFaces> method : TOPIC.methods())
            assertEquals(
                    0,
                    method.implementation().visible(new double[0], new int[0][], EYE, NONE).length);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("badInput")
    void everyMethodRefuses(
            double[] xyz, int[][] faces, double[] eye, double[] inside, String message) {
        for (Method<VisibleFaces> method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> method.implementation().visible(xyz, faces, eye, inside),
                            method.name());
            assertEquals(message, refusal.getMessage(), method.name());
        }
    }

    static Stream<Arguments> badInput() {
        return Stream.of(
                argumentSet(
                        "NaN is a coordinate",
                        new double[] {0, 0, 0, 1, Double.NaN, 0, 0, 1, 0},
                        ONE_FACE,
                        EYE,
                        NONE,
                        "vertex 1: y must be finite, got NaN"),
                argumentSet(
                        "infinity is an eye",
                        TRIANGLE,
                        ONE_FACE,
                        new double[] {0, 0, Double.POSITIVE_INFINITY},
                        NONE,
                        "eye coordinate 2 must be finite, got Infinity"),
                argumentSet(
                        "inner point lacks a number",
                        TRIANGLE,
                        ONE_FACE,
                        EYE,
                        new double[] {1, 2},
                        "inside needs 3 numbers, got [1.0, 2.0]"),
                argumentSet(
                        "corner past the vertices is read",
                        TRIANGLE,
                        new int[][] {{0, 1, 2}, {0, 1, 3}},
                        EYE,
                        NONE,
                        "face 1: corner must be a vertex from 0 to 2, got 3"),
                argumentSet(
                        "two corners are a face",
                        TRIANGLE,
                        new int[][] {{0, 1}},
                        EYE,
                        NONE,
                        "face 0 needs at least 3 corners, got 2"),
                argumentSet(
                        "half a vertex is left out",
                        new double[] {0, 0, 0, 1},
                        ONE_FACE,
                        EYE,
                        NONE,
                        "vertices must have 3 numbers each, got 4 in all"),
                argumentSet(
                        "corner of no vertices",
                        NONE,
                        ONE_FACE,
                        EYE,
                        NONE,
                        "face 0: corner must be a vertex, of which there are none, got 0"));
    }
}
