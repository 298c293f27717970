package rasterlab.engine.light.shade;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;

class ShadeTest {
    private static final ShadeTopic TOPIC = new ShadeTopic();
    private static final double[] UP = {0, 0, 1};
    private static final double[] SLANTED = {0.6, 0, 0.8};

    @ParameterizedTest(name = "chapter 7: {argumentSetName}")
    @MethodSource("worked")
    void intensityIs(String method, double[] toEye, Attenuation attenuation, double right) {
        PointShader shader = TOPIC.method(method).implementation();
        double[] i = shader.intensity(lit(UP, SLANTED, toEye, attenuation));
        assertArrayEquals(new double[] {right, right, right}, i, 1e-15);
    }

    /** kₐ = 0.1 of a global 1, k_d = 0.5, k_s = 0.2, s = 2, n·l = 0.8, d = 2. */
    static Stream<Arguments> worked() {
        Attenuation none = Attenuation.none();
        double[] mirror = {-0.6, 0, 0.8};
        return Stream.of(
                argumentSet("Lambert has a highlight", "lambert", mirror, none, 0.1 + 0.4),
                argumentSet("r is not mirrored", "phong", mirror, none, 0.1 + 0.4 + 0.2),
                argumentSet(
                        "the angle to the eye is not raised to s",
                        "phong",
                        UP,
                        none,
                        0.5 + 0.2 * 0.64),
                argumentSet("h is not half way", "blinn-phong", mirror, none, 0.1 + 0.4 + 0.2),
                argumentSet(
                        "h is not brought to length 1",
                        "blinn-phong",
                        UP,
                        none,
                        0.5 + 0.2 * 1.8 * 1.8 / (0.36 + 1.8 * 1.8)),
                argumentSet(
                        "1/(R + r²) weakens the ambient light too",
                        "lambert",
                        UP,
                        Attenuation.bySquare(1),
                        0.1 + 0.4 / 5),
                argumentSet(
                        "1/(K + d) takes the square",
                        "lambert",
                        UP,
                        new Attenuation(2, 1, 0),
                        0.1 + 0.4 / 4));
    }

    @Test
    void termsAddUpToTheIntensity() {
        LitPoint point = lit(UP, SLANTED, UP, Attenuation.none());
        Terms terms = new FormulaShader(Reflection.PHONG).terms(point);
        assertEquals(0.1, terms.globalAmbient()[0], 1e-15);
        assertEquals(0.4, terms.diffuse()[0], 1e-15);
        assertEquals(0.2 * 0.64, terms.specular()[0], 1e-15);
        assertEquals(0.628, terms.intensity()[0], 1e-15);
    }

    @Test
    void coneDimsTowardsItsRimAndEndsThere() {
        var shader = new FormulaShader(Reflection.LAMBERT);
        double[] down = {0, 0, -1};
        LitPoint inside = spot(new SpotCone(down, 40, 2));
        assertEquals(0.64, shader.terms(inside).cone(), 1e-15);
        LitPoint outside = spot(new SpotCone(down, 36, 2)); // cos⁻¹ 0.8 is 36.87°
        assertEquals(0, shader.terms(outside).cone());
    }

    private static LitPoint spot(SpotCone cone) {
        return new LitPoint(
                UP, SLANTED, UP, 2, material(), LightSource.white().through(cone), new double[3]);
    }

    @Test
    void noHighlightWhereTheLightIsBehind() {
        double[] behind = {0.6, 0, -0.8};
        LitPoint point = lit(UP, behind, new double[] {-0.6, 0, -0.8}, Attenuation.none());
        for (String method : new String[] {"phong", "blinn-phong"})
            assertEquals(0.1, TOPIC.method(method).implementation().intensity(point)[0], method);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("refusals")
    void refuses(Executable call, String message) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, call).getMessage());
    }

    static Stream<Arguments> refusals() {
        double[] zero = new double[3];
        double[] nan = {0, Double.NaN, 0};
        Attenuation none = Attenuation.none();
        return Stream.of(
                refusal(
                        "a zero normal is divided by 0",
                        () -> phong(lit(zero, UP, UP, none)),
                        "normal must not be zero, got (0, 0, 0)"),
                refusal(
                        "a light in the point is divided by 0",
                        () -> phong(lit(UP, zero, UP, none)),
                        "to-light must not be zero, got (0, 0, 0)"),
                refusal(
                        "an eye in the point is divided by 0",
                        () -> phong(lit(UP, UP, zero, none)),
                        "to-eye must not be zero, got (0, 0, 0)"),
                refusal(
                        "NaN is shaded",
                        () -> lit(nan, UP, UP, none),
                        "normal must be finite, got (0.0, NaN, 0.0)"),
                refusal(
                        "attenuation is 1/0",
                        () -> new Attenuation(0, 0, 0),
                        "attenuation needs a number above 0, got 0, 0 and 0"),
                refusal(
                        "attenuation is negative",
                        () -> new Attenuation(1, -1, 0),
                        "attenuation's linear must be finite and not negative, got -1.0"),
                refusal(
                        "a cone opens beyond a half space",
                        () -> new SpotCone(UP, 91, 0),
                        "cutoff must be from 0 to 90 degrees, or 180 for none, got 91.0"),
                refusal(
                        "a surface sends back more than it gets",
                        () -> new SurfaceMaterial(zero, new double[] {1, 1, 1.5}, zero, zero, 0),
                        "diffuse must have shares from 0 to 1, got (1.0, 1.0, 1.5)"),
                refusal(
                        "a highlight is sharper than its formula allows",
                        () -> new SurfaceMaterial(zero, zero, zero, zero, 201),
                        "shininess must be from 0 to 200, got 201.0"));
    }

    private static Arguments refusal(String mistake, Executable call, String message) {
        return argumentSet(mistake, call, message);
    }

    private static double[] phong(LitPoint point) {
        return new FormulaShader(Reflection.PHONG).intensity(point);
    }

    private static LitPoint lit(
            double[] normal, double[] toLight, double[] toEye, Attenuation attenuation) {
        return new LitPoint(
                normal,
                toLight,
                toEye,
                2,
                material(),
                LightSource.white().attenuated(attenuation),
                new double[] {1, 1, 1});
    }

    private static SurfaceMaterial material() {
        return new SurfaceMaterial(gray(0.1), gray(0.5), gray(0.2), gray(0), 2);
    }

    private static double[] gray(double share) {
        return new double[] {share, share, share};
    }
}
