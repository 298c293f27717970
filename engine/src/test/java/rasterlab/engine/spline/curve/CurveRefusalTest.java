package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Curve;
import rasterlab.contract.Curve.Kind;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.exact.Polyline;

/** Input that no method may take, and input that looks as if it were such. */
class CurveRefusalTest {
    private static final double[] FOUR = {0, 1, 2, 3};

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("curves")
    void noCurveIsMade(Kind kind, double[] x, double[] y, String message) {
        var refusal = assertThrows(IllegalArgumentException.class, () -> new Curve(kind, x, y));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> curves() {
        double[] none = {};
        double[] million = new double[1_000_000];
        return Stream.of(
                argumentSet(
                        "no point",
                        Kind.BEZIER,
                        none,
                        none,
                        "points must be 1 to 101 for bezier, got 0"),
                argumentSet(
                        "too many for one Bézier curve",
                        Kind.BEZIER,
                        million,
                        million,
                        "points must be 1 to 101 for bezier, got 1000000"),
                argumentSet(
                        "Hermite of five",
                        Kind.HERMITE,
                        new double[5],
                        new double[5],
                        "points must be 4 for hermite, got 5"),
                argumentSet(
                        "B-spline of three",
                        Kind.B_SPLINE,
                        new double[3],
                        new double[3],
                        "points must be 4 to 1000000 for b-spline, got 3"),
                argumentSet("y is missing", Kind.BEZIER, FOUR, none, "points: 4 have x, 0 have y"),
                argumentSet(
                        "coordinate is NaN",
                        Kind.BEZIER,
                        FOUR,
                        new double[] {0, 1, Double.NaN, 3},
                        "points[2].y must be from -1.0E100 to 1.0E100, got NaN"),
                argumentSet(
                        "coordinate at the doubles' limit",
                        Kind.BEZIER,
                        new double[] {0, -Double.MAX_VALUE, 0, 0},
                        FOUR,
                        "points[1].x must be from -1.0E100 to 1.0E100, got -1.7976931348623157E308"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("flatnesses")
    void everyMethodRefusesTheFlatness(double flatness, String message) {
        var curve = new Curve(Kind.BEZIER, FOUR, FOUR);
        for (var method : new CurveTopic().methods()) {
            CurveTracer tracer = method.implementation();
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> tracer.flatten(curve, flatness, new Polyline(9)));
            assertEquals(message, refusal.getMessage(), method.name());
        }
    }

    static Stream<Arguments> flatnesses() {
        String range = "flatness must be from 1.0E-100 to 1.0E100, got ";
        return Stream.of(
                argumentSet("never flat enough", 0, range + "0.0"),
                argumentSet("negative", -1, range + "-1.0"),
                argumentSet("not a number", Double.NaN, range + "NaN"),
                argumentSet("infinite", Double.POSITIVE_INFINITY, range + "Infinity"));
    }

    @Test
    void everyMethodNamesTheFirstTOutside() {
        var curve = new Curve(Kind.BEZIER, FOUR, FOUR);
        for (double wrong : new double[] {-1e-9, 1.0000001, Double.NaN})
            for (var method : new CurveTopic().methods()) {
                CurveTracer tracer = method.implementation();
                var refusal =
                        assertThrows(
                                IllegalArgumentException.class,
                                () -> tracer.at(curve, new double[] {0, wrong}, new Polyline(9)));
                assertEquals("at[1] must be from 0 to 1, got " + wrong, refusal.getMessage());
            }
    }

    @Test
    void tooManySegmentsAreRefusedBeforeTheFirst() {
        var x = new double[1_000_000];
        Arrays.setAll(x, i -> (i & 1) * 1e6);
        var curve = new Curve(Kind.B_SPLINE, x, x);
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new AdaptiveCurve().flatten(curve, 1, new Polyline(0)));
        assertTrue(refusal.getMessage().endsWith("at most 10000000 are allowed"), "message");
    }

    @Test
    void aMillionPointsAreDrawn() {
        var x = new double[1_000_000];
        var y = new double[1_000_000];
        Arrays.setAll(x, i -> i);
        Arrays.setAll(y, i -> i % 7);
        for (CurveTracer method : new CurveTracer[] {new UniformCurve(), new AdaptiveCurve()}) {
            var line = new Polyline(Integer.MAX_VALUE);
            method.flatten(new Curve(Kind.CATMULL_ROM, x, y), 0.25, line);
            assertEquals(1, line.x(0));
            assertEquals(999_998, line.x(line.size() - 1));
        }
    }

    @Test
    void lowDegreesAreCurvesToo() {
        double[][] points = {{5}, {5, 9}, {5, 6, 9}};
        for (double[] x : points)
            for (var method : new CurveTopic().methods()) {
                if (method.faulty()) continue;
                var line = new Polyline(99);
                method.implementation().flatten(new Curve(Kind.BEZIER, x, x), 0.25, line);
                assertTrue(line.size() >= 2, method.name());
                assertEquals(5, line.x(0), 1e-12, method.name());
                assertEquals(x[x.length - 1], line.x(line.size() - 1), 1e-5, method.name());
            }
    }
}
