package rasterlab.engine.border;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.AxisRotation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LinePlane;
import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.clip.segment.ClipWindow;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.study.Method;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.filter.FilteredPixels;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.view.ViewTask;
import rasterlab.engine.transform.view.ViewTopic;

/** Inputs that went wrong once, with answers found by hand. */
class KnownBordersTest {
    private static final double TINY = Double.MIN_VALUE;

    static Stream<Arguments> segments() {
        var cases = new ArrayList<Arguments>();
        for (var method : promising(new SegmentClipTopic().methods())) {
            cases.add(clip(method, "-0.0 on a side", "0 0 1 1", "0 -0.0 0 -0.0", 0, 0, 0, 0));
            cases.add(clip(method, "along a side at -0.0", "0 0 3 6", "1 -0.0 2 -0.0", 1, 0, 2, 0));
            cases.add(clip(method, "side at -0.0", "-0.0 -1 -0.0 1", "0 0 0 0", 0, 0, 0, 0));
            cases.add(clip(method, "narrowest", "0 3 0 6", TINY + " 0 0 6", 0, 6, 0, 6));
            cases.add(
                    clip(
                            method,
                            "flattest",
                            "-7 1e-323 1.5 6.375",
                            "-3.75 0 6.75 2.5e-323",
                            0.45,
                            1e-323,
                            1.5,
                            1.5e-323));
            cases.add(clip(method, "just beyond", "0 0 5 3", "-3 5 5 " + -TINY, 0.2, 3, 5, 0));
        }
        return cases.stream();
    }

    private static <C> List<Method<C>> promising(List<Method<C>> methods) {
        return methods.stream().filter(Method::promisesToBeRight).toList();
    }

    private static Arguments clip(
            Method<SegmentClipper> method,
            String name,
            String window,
            String ends,
            double... left) {
        return argumentSet(
                method.name() + ": " + name,
                method.implementation(),
                numbers(window),
                numbers(ends),
                left);
    }

    private static double[] numbers(String text) {
        return Stream.of(text.split(" ")).mapToDouble(Double::parseDouble).toArray();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("segments")
    void aSegmentAtTheBordersIsClippedRight(
            SegmentClipper method, double[] window, double[] ends, double[] right) {
        var left = new ArrayList<double[]>();
        method.clip(
                window[0],
                window[1],
                window[2],
                window[3],
                ends[0],
                ends[1],
                ends[2],
                ends[3],
                (x0, y0, x1, y1) -> left.add(new double[] {x0, y0, x1, y1}));
        assertEquals(1, left.size(), "what is sent");
        double[] part = left.get(0);
        assertArrayEquals(right, part, 1e-12);
        var sides = new ClipWindow(window[0], window[1], window[2], window[3]);
        assertEquals(0, sides.code(part[0], part[1]), "sides that its first end lies beyond");
        assertEquals(0, sides.code(part[2], part[3]), "sides that its second end lies beyond");
    }

    static Stream<Arguments> meetings() {
        return Stream.of(
                argumentSet(
                        "plane a step beside the line's first point",
                        Math.nextUp(1.0),
                        numbers("1 0 0"),
                        numbers("2 0 0"),
                        Math.ulp(1.0)),
                argumentSet(
                        "plane far away",
                        100_000_000.3,
                        numbers("100000000.1 0 0"),
                        numbers("100000001.1 0 0"),
                        0.2000000030));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("meetings")
    void aPlanesPointIsTakenAsItIsGiven(double x, double[] from, double[] through, double mu) {
        LinePlane unrounded = new LinePlaneTopic().method("unrounded").implementation();
        double[] normal = numbers("0.1 0.3 0.7");
        double[] point = {x, 0, 0};
        assertEquals(mu, unrounded.meetsThrough(normal, point, from, through), 1e-9 * mu);
    }

    /** Half of it shows row 0, half of it row 1, of which a third is white. */
    @Test
    void theReferenceOfAFootprintAsThinAsRoundingHalvesIt() {
        int[] argb = {0, 0, 0, -1, 0, 0};
        double[] footprint = {0, 0, 3, 0, 0, 5.611686041902098E-14};
        double[] levels = new FilterTopic().exact(new FilteredPixels(3, 2, argb, footprint), 1);
        assertArrayEquals(new double[] {42.5, 42.5, 42.5, 42.5}, levels, 1e-9);
    }

    /** Half of it shows row 2, which is white, half of it row 0 of the next copy. */
    @Test
    void theReferenceOfAThinFootprintOnABorderHalvesIt() {
        double[] footprint = {0, -1, 1, 0, 0, 1.0862699437302849E-9};
        int[] argb = {0, 0, -1};
        double[] levels = new FilterTopic().exact(new FilteredPixels(1, 3, argb, footprint), 1);
        assertArrayEquals(new double[] {127.5, 127.5, 127.5, 127.5}, levels, 1e-9);
    }

    /** The footprint lies in the last column, next to the first one, which is black. */
    @Test
    void aThinFootprintBesideABorderShowsItsOwnTexels() {
        int[] argb = {0, 0, 0, 0, 0, 0, 0, -1};
        double[] footprint = {0.9999999788923446, 0, 7.450580596923828E-9, 0, 0, 1};
        var topic = new FilterTopic();
        var pixels = new FilteredPixels(4, 2, argb, footprint);
        for (var method : promising(topic.methods())) {
            double[] levels = topic.record(method.implementation(), pixels, 1);
            assertArrayEquals(new double[] {127.5, 127.5, 127.5, 127.5}, levels, 0.5);
        }
    }

    /** n·l is 2·10⁻³⁰⁸ − 2·10⁻¹¹⁹: the third normal's length is above 1 by 7·10⁻⁸⁰. */
    @Test
    void aLampAHairBehindAMixedNormalGivesNoHighlight() {
        double little = 0x1p-131;
        double[] nothing = new double[3];
        double[] green = {0, 1, 0};
        var face =
                new LitFace(
                        numbers("0 0 0 0 0 0 0 -1 -1"),
                        new double[] {0, 0, -1, 0, 0, 0, Double.MIN_NORMAL, 1, little},
                        numbers("1 -1 0"),
                        nothing,
                        new SurfaceMaterial(nothing, nothing, green, nothing, 0),
                        LightSource.white(),
                        nothing);
        var points = new FacePoints(face, new double[] {little, 0, 1});
        var topic = new FaceTopic();
        assertArrayEquals(nothing, topic.exact(points, 1));
        for (var method : promising(topic.methods()))
            assertArrayEquals(nothing, topic.record(method.implementation(), points, 1));
    }

    static Stream<Arguments> highlights() {
        double most = Double.MAX_VALUE;
        return Stream.of(
                argumentSet("below the smallest normal", -most, 1.0, Double.MIN_NORMAL, 1.0),
                argumentSet("below the smallest double", -1e300, 1e-100, 0.001, 0.398107170553497),
                argumentSet(
                        "next to the smallest double", -1e300, 7e-24, 0.01, 0.0005867471386754139),
                argumentSet("at right angles", -1.0, 0.0, Double.MIN_NORMAL, 0.0),
                argumentSet("a hair beyond", -1e300, -1.0, Double.MIN_NORMAL, 0.0));
    }

    /** r is z, and v is (0, y, z) with y far below 0, so r·v is z / |y|. */
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("highlights")
    void aHighlightAHairThisSideOfTheMirrorIsSeen(
            double y, double z, double shininess, double red) {
        double[] nothing = new double[3];
        double[] all = {1, 0, 0};
        var point =
                new LitPoint(
                        numbers("0 1 1"),
                        numbers("0 1 0"),
                        new double[] {0, y, z},
                        0,
                        new SurfaceMaterial(nothing, nothing, all, nothing, shininess),
                        LightSource.white(),
                        nothing);
        var topic = new ShadeTopic();
        var points = new LitPoints(List.of(point));
        double[] right = {red, 0, 0};
        assertArrayEquals(right, topic.exact(points, 1).rgb().get(Reflection.PHONG), 1e-12);
        double[] seen = topic.method("phong").implementation().intensity(point);
        assertArrayEquals(right, seen, 1e-12);
    }

    /** Some subnormal steps off, which is a quarter of what there is to see. */
    @Test
    void aViewOfTheSmallestDoublesMayRoundThem() {
        var topic = new ViewTopic();
        var look = new ViewTask(-10, -1, TINY, new double[] {0, 1.5E-323, 2.0E-323});
        for (var method : promising(topic.methods())) {
            var seen = topic.record(method.implementation(), look, 1);
            assertTrue(topic.correct(topic.compare(look, topic.exact(look, 1), seen)));
        }
    }

    /** sin of the angle is 10⁻¹⁵, and so much of the largest double its point is moved by. */
    @Test
    void anAxisThroughTheLargestDoubleMovesByWhatIsADouble() {
        double most = Double.MAX_VALUE;
        double degrees = 5.755166896282639E-14;
        double[][] rows =
                new MatrixTopic()
                        .method("formula")
                        .implementation()
                        .rows("ROTAXIS", most, most, 0, 0, 0, 1, degrees);
        double moved = Math.toRadians(degrees) * most;
        assertArrayEquals(new double[] {moved, -moved, 0, 1}, rows[3], 1e-15 * most);
    }

    static Stream<Arguments> turns() {
        return promising(new AxisTopic().methods()).stream()
                .map(method -> argumentSet(method.name(), method.implementation()));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("turns")
    void anAxisThatIsBesideZByTheSmallestDoubleTurnsAboutZ(AxisRotation method) {
        var point = new double[] {1, 0, 0};
        method.rotate(new double[3], new double[] {TINY, TINY, 1}, 45, point);
        double root = Math.sqrt(0.5);
        assertArrayEquals(new double[] {root, root, 0}, point, 1e-15);
    }
}
