package rasterlab.engine.transform.chain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.engine.transform.chain.TransformWorkloads.cells;

import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.scene.House;
import rasterlab.engine.scene.HouseTables;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;

class TransformTest {
    private static final TransformTopic TOPIC = new TransformTopic();
    private static final double[] ONE = cells("IDENTITY");

    static Stream<Method<PointTransformer>> methods() {
        return TOPIC.methods().stream().filter(method -> !method.faulty());
    }

    private static double[] image(Method<PointTransformer> method, double[] h, Chain chain) {
        double[] points = chain.points().clone();
        System.arraycopy(chain.h(), 0, h, 0, h.length);
        method.implementation().transform(chain.dimension(), chain.matrices(), points, h);
        return points;
    }

    private static double[] ones(int count) {
        return DoubleStream.generate(() -> 1).limit(count).toArray();
    }

    @ParameterizedTest
    @MethodSource("methods")
    void lectureHomogeneousPointsAreDividedByH(Method<PointTransformer> method) {
        var h = new double[1];
        double[] nonProportional = {1, 0, 0.5, 0, 1, 0.5, 0, 0, 1};
        var chain = new Chain(2, new double[][] {nonProportional}, new double[] {2, 4});
        assertArrayEquals(new double[] {0.5, 1}, image(method, h, chain));
        assertArrayEquals(new double[] {4}, h);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void firstMatrixIsAppliedFirst(Method<PointTransformer> method) {
        double[][] list = {cells("TRANSL2D", 1, 0), cells("ROT2D", 90)};
        double[] image = image(method, new double[1], new Chain(2, list, new double[] {2, 0}));
        assertArrayEquals(new double[] {0, 3}, image);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void pointAtInfinityHasNoImageAndHSaysSo(Method<PointTransformer> method) {
        double[] h = {7, 7};
        double[][] list = {cells("PERSPECTIVE", 0, 0, 0.5)};
        var chain = new Chain(3, list, new double[] {1, 2, -2, 1, 2, -4});
        double[] image = image(method, h, chain);
        assertArrayEquals(new double[] {0, -1}, h);
        double nan = Double.NaN;
        assertArrayEquals(new double[] {nan, nan, nan, -1, -2, 4}, image);
    }

    /** [4 2], [6 3] and [8 4] are all the point 2 of the line; here as [x y h] with y = 0. */
    @ParameterizedTest
    @MethodSource("methods")
    void lectureOnePointHasManyRepresentations(Method<PointTransformer> method) {
        for (double h : new double[] {2, 3, 4}) {
            double[][] list = {{h, 0, 0, 0, h, 0, 0, 0, h}};
            var actualH = new double[1];
            double[] image = image(method, actualH, new Chain(2, list, new double[] {2, 0}));
            assertArrayEquals(new double[] {2, 0}, image);
            assertArrayEquals(new double[] {h}, actualH);
        }
    }

    @ParameterizedTest
    @MethodSource("methods")
    void pointAtInfinityGoesToTheVanishingPoint(Method<PointTransformer> method) {
        double[][] list = {cells("ROT3DY", 90), cells("PERSPECTIVE", 0, 0, -0.25)};
        var chain = new Chain(3, list, new double[] {1, 0, 0}, new double[] {0});
        var h = new double[1];
        assertArrayEquals(new double[] {0, 0, -4}, image(method, h, chain), 1e-6);
        assertEquals(0.25, h[0], 1e-7);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void allRepresentationsOfAPointHaveOneImage(Method<PointTransformer> method) {
        double[][] list = {cells("TRANSL3D", 5, 6, 7)};
        double[] points = {2, 4, 6, -1, -2, -3, 1, 2, 3};
        var h = new double[3];
        double[] image = image(method, h, new Chain(3, list, points, new double[] {2, -1, 1}));
        assertArrayEquals(new double[] {6, 8, 10, 6, 8, 10, 6, 8, 10}, image);
        assertArrayEquals(new double[] {2, -1, 1}, h);
    }

    /** H = −1: mirrored, and by its H no longer to be told from the point before the eye. */
    @Test
    void textbookTakesAPointBehindTheEyeForOneBeforeIt() {
        double[][] list = {cells("PERSPECTIVE", 0, 0, -1 / 512.0)};
        double[] points = {3, 4, 256, 3, 4, 1024, 3, 4, 512};
        double[] h = ones(3);
        TOPIC.method("divide-first-textbook").implementation().transform(3, list, points, h);
        assertArrayEquals(new double[] {1, 1, 1}, h);
        double far = Double.POSITIVE_INFINITY;
        assertArrayEquals(new double[] {6, 8, 512, -3, -4, -1024, far, far, far}, points);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void noMatrixIsTheIdentity(Method<PointTransformer> method) {
        var h = new double[1];
        var chain = new Chain(3, new double[0][], new double[] {1, 2, 3});
        assertArrayEquals(new double[] {1, 2, 3}, image(method, h, chain));
        assertArrayEquals(new double[] {1}, h);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void lectureHouseOnTheScreen(Method<PointTransformer> method) {
        double[][] list = {
            cells("SCALE3D", 1 / 16.0),
            cells("ROT3DX", -90),
            cells("ROT3DY", -40),
            cells("ROT3DX", 10),
            cells("TRANSL3D", 0, -150, 0),
            cells("PERSPECTIVE", 0, 0, -1 / 700.0)
        };
        double[] image = image(method, new double[10], new Chain(3, list, House.vertices()));
        double tolerance = method.name().equals("float") ? 1e-3 : 1e-9;
        double[][] screen = HouseTables.screen();
        for (int v = 0; v < 10; v++)
            for (int j = 0; j < 3; j++)
                assertEquals(screen[v][j], image[3 * v + j], tolerance, "vertex " + (v + 1));
    }

    @Test
    void lectureMidpointsAndParallelsArePreservedByAffineChains() {
        var random = new Random(28);
        double[] cells = random.doubles(9, -2, 2).toArray();
        cells[2] = 0;
        cells[5] = 0;
        cells[8] = 1;
        // Two parallel segments and the middle of the first.
        double[] points = {1, 2, 5, 8, 3, 5, 0, 0, 4, 6};
        var method = TOPIC.method("double").implementation();
        method.transform(2, new double[][] {cells}, points, ones(5));
        assertEquals((points[0] + points[2]) / 2, points[4], 1e-14);
        assertEquals((points[1] + points[3]) / 2, points[5], 1e-14);
        double cross =
                (points[2] - points[0]) * (points[9] - points[7])
                        - (points[3] - points[1]) * (points[8] - points[6]);
        assertEquals(0, cross, 1e-12);
    }

    @Test
    void doubleDoubleIsRightToItsLastBitOnRandomChains() {
        long seed = 1971;
        var random = new Random(seed);
        var method = TOPIC.method("double-double").implementation();
        for (int i = 0; i < 300; i++) {
            var matrices = new double[1 + random.nextInt(5)][];
            for (int m = 0; m < matrices.length; m++)
                matrices[m] = random.doubles(16, -10, 10).toArray();
            var chain = new Chain(3, matrices, random.doubles(9, -100, 100).toArray());
            Deviation deviation =
                    TOPIC.compare(chain, TOPIC.exact(chain, 9), TOPIC.record(method, chain, 9));
            assertTrue(deviation.worst() <= 0x1p-52, () -> "seed " + seed + " " + deviation);
        }
    }

    @Test
    @DisplayName("right images with H left out, turned round or rounded pass for exact")
    void judgesHBesideTheImages() {
        var right = TOPIC.method("double-double").implementation();
        double[][] list = {cells("PERSPECTIVE", 0, 0, 0.5)};
        var chain = new Chain(3, list, new double[] {1, 2, -4, 1, 2, 3});
        for (double factor : new double[] {0, -1, 1 + 1e-9, Double.NaN}) {
            PointTransformer mutant =
                    (dimension, matrices, points, h) -> {
                        right.transform(dimension, matrices, points, h);
                        h[1] *= factor;
                    };
            Deviation deviation =
                    TOPIC.compare(chain, TOPIC.exact(chain, 9), TOPIC.record(mutant, chain, 9));
            assertFalse(TOPIC.correct(deviation), "H times " + factor);
            assertEquals("H of points[1] is " + 2.5 * factor + ", right is 2.5", deviation.first());
        }
    }

    @ParameterizedTest(name = "{0} counts other work than it does")
    @ValueSource(strings = {"divide-first-textbook", "float", "double"})
    void countingTwinGivesTheSameImages(String name) {
        var random = new Random(17);
        var counting = new CountingChain(name.equals("float"));
        for (int i = 0; i < 100; i++) {
            double[][] list = {
                random.doubles(16, -9, 9).toArray(), random.doubles(16, -9, 9).toArray()
            };
            var chain = new Chain(3, list, random.doubles(6, -9, 9).toArray());
            double[] counted = chain.points().clone();
            if (name.startsWith("divide")) counting.divideFirst(chain, counted);
            else counting.transform(chain, counted);
            assertArrayEquals(image(TOPIC.method(name), new double[2], chain), counted);
        }
    }

    @Test
    void transformsAMillionPoints() {
        double[] points = new Random(1).doubles(3_000_000, -1, 1).toArray();
        double[] before = points.clone();
        double[][] list = {cells("ROT3DX", 33), cells("ROT3DX", -33)};
        var method = TOPIC.method("double").implementation();
        method.transform(3, list, points, ones(1_000_000));
        assertArrayEquals(before, points, 1e-15);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(int dimension, double[][] matrices, double[] points, String message) {
        for (Method<PointTransformer> method : methods().toList()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () ->
                                    method.implementation()
                                            .transform(
                                                    dimension,
                                                    matrices,
                                                    points.clone(),
                                                    ones(points.length / 3)),
                            method.name());
            String said = refusal.getMessage();
            assertTrue(said.matches(message), method.name() + ": " + said);
        }
    }

    static Stream<Arguments> mistakes() {
        double[] origin = {0, 0, 0};
        double[] nan = ONE.clone();
        nan[7] = Double.NaN;
        double[] tiny = cells("SCALE3DX", 1e-200);
        double[] huge = cells("SCALE3DX", 1e200);
        return Stream.of(
                argumentSet(
                        "points of one number",
                        1,
                        list(),
                        origin,
                        "dimension must be 2 or 3, got 1"),
                argumentSet(
                        "a plane's matrix for points of space",
                        3,
                        list(cells("ROT2D", 1)),
                        origin,
                        "matrices\\[0\\] must have 16 cells for these points, got 9"),
                argumentSet(
                        "a NaN cell",
                        3,
                        list(ONE, nan),
                        origin,
                        "matrices\\[1\\], row 2, column 4 must be a finite number, got NaN"),
                argumentSet(
                        "an infinite point",
                        3,
                        list(ONE),
                        new double[] {0, 0, 0, 0, 1 / 0.0, 0},
                        "points\\[1\\].y must be a finite number from .*, got Infinity"),
                argumentSet(
                        "half a point",
                        3,
                        list(ONE),
                        new double[] {1, 2},
                        "points must have 3 numbers each, got 2 numbers in all"),
                argumentSet(
                        "an unseen overflow of the product",
                        3,
                        list(huge, huge),
                        new double[] {1, 1, 1},
                        "the product of the matrices is too large.*|matrices.*a float holds.*"),
                argumentSet(
                        "an unseen overflow of an image",
                        3,
                        list(huge),
                        new double[] {1e200, 1, 1},
                        "points\\[0\\]: its image is too large.*|points.*from -1.3.*"),
                argumentSet(
                        "factors that vanish and come back",
                        3,
                        list(tiny, tiny, huge, huge),
                        new double[] {1, 1, 1},
                        "the product of 1.0E-200 and 1.0E-200 is too small.*|matrices.*a float holds.*"));
    }

    private static double[][] list(double[]... matrices) {
        return matrices;
    }
}
