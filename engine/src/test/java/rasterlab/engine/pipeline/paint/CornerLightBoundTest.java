package rasterlab.engine.pipeline.paint;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Material;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/** Random triangles in the light of one lamp: what the bound says, and what is measured. */
class CornerLightBoundTest {
    private static final int TRIANGLES = 600;

    /** Steps along a side in which light is measured. */
    private static final int STEPS = 12;

    /** Error of a colour in floats, in levels. */
    private static final double ROUNDING = 0.02;

    /** The share of the bound that is measured on some triangle. */
    private static final double NEAR = 0.15;

    private static final SphericalView EYE = new SphericalView(0.5, 1, 6);

    @ParameterizedTest(name = "{argumentSetName}: the bound is below the error, or far above it")
    @MethodSource("lamps")
    void boundIsAboveTheErrorAndNear(LightSource source, double distance, Reflection reflection) {
        var random = new Random(7);
        double nearest = 0;
        for (int k = 0; k < TRIANGLES; k++) {
            FaceLights lights = triangle(random, source, distance, reflection);
            double bound = new CornerLightBound(lights, 0).levels(0);
            if (Double.isInfinite(bound)) continue;
            double error = measured(lights);
            int triangle = k;
            assertTrue(
                    error <= bound + ROUNDING,
                    () -> "triangle " + triangle + ": " + error + " levels, bound " + bound);
            if (bound > 0.5) nearest = Math.max(nearest, error / bound);
        }
        assertTrue(nearest > NEAR, "at most " + nearest + " of the bound is measured");
    }

    static Stream<Arguments> lamps() {
        double[] none = new double[3];
        double[] white = {1, 1, 1};
        var dull = new LightSource(none, white, none, Attenuation.none(), SpotCone.none());
        var shiny = new LightSource(none, none, white, Attenuation.none(), SpotCone.none());
        var ambient = new LightSource(white, none, none, Attenuation.none(), SpotCone.none());
        var fading = new Attenuation(0, 0, 2);
        var slowly = new Attenuation(0.2, 0.8, 0);
        var cone = new SpotCone(new double[] {0, 0, -1}, 60, 12);
        return Stream.of(
                lamp("sun", dull, 0, Reflection.LAMBERT),
                lamp("lamp", dull, 3, Reflection.LAMBERT),
                lamp("highlight by n·h", shiny, 0, Reflection.BLINN_PHONG),
                lamp("highlight by r·v", shiny, 0, Reflection.PHONG),
                lamp("lamp's highlight", shiny, 3, Reflection.BLINN_PHONG),
                lamp("light that fades", dull.attenuated(fading), 2, Reflection.LAMBERT),
                lamp("slow fading", dull.attenuated(slowly), 2, Reflection.LAMBERT),
                lamp("ambient fading", ambient.attenuated(fading), 2, Reflection.LAMBERT),
                lamp("cone", dull.through(cone), 3, Reflection.LAMBERT),
                lamp("cone's highlight", shiny.through(cone), 3, Reflection.BLINN_PHONG),
                lamp("fading cone", dull.attenuated(fading).through(cone), 2, Reflection.LAMBERT));
    }

    private static Arguments lamp(
            String name, LightSource source, double distance, Reflection reflection) {
        return argumentSet(name, source, distance, reflection);
    }

    /**
     * @param distance of the lamp above the origin, about which the triangle lies; 0 for a sun
     */
    private static FaceLights triangle(
            Random random, LightSource source, double distance, Reflection reflection) {
        double size = Math.pow(10, -1.3 * random.nextDouble());
        double bent = 0.6 * random.nextDouble();
        double[] normal = {random.nextGaussian() / 2, random.nextGaussian() / 2, 1};
        var xyz = new double[9];
        var normals = new double[9];
        double[] middle = {random.nextGaussian() / 2, random.nextGaussian() / 2, 0};
        for (int k = 0; k < 3; k++) {
            double length = 0;
            for (int i = 0; i < 3; i++) {
                xyz[3 * k + i] = middle[i] + (i < 2 ? size * (random.nextDouble() - 0.5) : 0);
                normals[3 * k + i] = normal[i] + bent * (random.nextDouble() - 0.5);
                length += normals[3 * k + i] * normals[3 * k + i];
            }
            for (int i = 0; i < 3; i++) normals[3 * k + i] /= Math.sqrt(length);
        }
        Mesh mesh = new Mesh(xyz, new int[][] {{0, 1, 2}}).withNormals(normals);
        Light light =
                distance == 0
                        ? Light.from(source, 0.2, 0.1, 1)
                        : Light.at(source, 0.2, 0.1, distance);
        var model = new LightModel(new double[3], true, false, reflection, List.of(light));
        double[] half = {0.5, 0.5, 0.5};
        var surface = new SurfaceMaterial(half, half, half, new double[3], 20);
        var scene =
                new Scene(
                        "triangle",
                        mesh,
                        List.of(Appearance.of(new Material(surface, 1))),
                        new int[1],
                        new SceneLight(model, Optional.empty()),
                        0,
                        EYE,
                        1);
        var transform = new ViewTransform(EYE, Projection.PERSPECTIVE);
        var view = new ViewedMesh(mesh, transform, PictureFit.of(80, 60, 1));
        return new FaceLights(scene, view, LightTerm.all(), Sides.SCENE);
    }

    /** The largest difference of mixed light from the formula, in levels. */
    private static double measured(FaceLights lights) {
        PointLighting formula = lights.forThread()[0];
        Mesh mesh = lights.mesh();
        float[] corners = lights.atCorners();
        var there = new float[4];
        double most = 0;
        for (int i = 0; i <= STEPS; i++)
            for (int j = 0; i + j <= STEPS; j++) {
                double[] share = {
                    (double) i / STEPS, (double) j / STEPS, (double) (STEPS - i - j) / STEPS
                };
                double[] at = new double[6];
                double mixed = 0;
                for (int k = 0; k < 3; k++) {
                    at[0] += share[k] * mesh.x(mesh.corner(0, k));
                    at[1] += share[k] * mesh.y(mesh.corner(0, k));
                    at[2] += share[k] * mesh.z(mesh.corner(0, k));
                    for (int axis = 0; axis < 3; axis++)
                        at[3 + axis] += share[k] * mesh.cornerNormal(0, k, axis);
                    mixed += share[k] * corners[4 * k];
                }
                formula.shade(at[0], at[1], at[2], at[3], at[4], at[5], false, there, 0);
                most = Math.max(most, 255 * Math.abs(mixed - there[0]));
            }
        return most;
    }
}
