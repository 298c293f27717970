package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.Reflection;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

class ShadingChoiceTest {
    @ParameterizedTest(name = "ball of {0} steps, {1}, within {2} levels: {3}")
    @CsvSource({
        "20, BLINN_PHONG, 8, phong",
        "20, PHONG, 8, phong",
        "20, LAMBERT, 1, phong",
        "200, LAMBERT, 3, gouraud",
        "400, LAMBERT, 8, flat",
        "400, LAMBERT, 0, phong"
    })
    void leastShadingIsTaken(int detail, Reflection reflection, double levels, String chosen) {
        Scene ball = Scenes.named("sphere", detail);
        var light = new SceneLight(ball.light().model().with(reflection), ball.light().atEye());
        RenderRequest request = seen(lit(ball, light), ball.defaultCamera(), "zfloat");
        assertEquals(chosen, ShadingChoice.of(request, levels).chosen());
    }

    @Test
    @DisplayName("shading is flat where light turns within a face, or mixed where it is not linear")
    void chosenShadingIsAsNearToPhongsAsItSays() {
        var random = new Random(32);
        Set<ShadingMethod> met = EnumSet.noneOf(ShadingMethod.class);
        try (var renderer = new Renderer()) {
            for (String name : Scenes.names())
                for (double levels : new double[] {1, 3, 8, 30}) {
                    Scene scene = scene(name, random);
                    for (String method : new String[] {Renderer.PIPELINE, "zfloat"}) {
                        RenderRequest exact = seen(scene, camera(scene, random), method);
                        var chosen = ShadingMethod.named(ShadingChoice.of(exact, levels).chosen());
                        if (chosen == ShadingMethod.PHONG) continue;
                        met.add(chosen);
                        var difference =
                                PictureDifference.of(
                                        renderer.render(exact, () -> false),
                                        renderer.render(
                                                exact.with(exact.look().withShading(chosen)),
                                                () -> false));
                        assertTrue(
                                difference.largestLevelDifference() <= levels,
                                name + ", " + method + ", " + exact.camera() + ": " + difference);
                    }
                }
        }
        assertEquals(EnumSet.of(ShadingMethod.FLAT, ShadingMethod.GOURAUD), met);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, 256, Double.NaN})
    void levelsOutOfRangeAreRefused(double levels) {
        Scene cube = Scenes.named("cube");
        RenderRequest request = seen(cube, cube.defaultCamera(), "zfloat");
        assertThrows(IllegalArgumentException.class, () -> ShadingChoice.of(request, levels));
    }

    /** A named scene, each second time as dull as can be. */
    private static Scene scene(String name, Random random) {
        Scene scene =
                Scenes.namesWithDetail().contains(name)
                        ? Scenes.named(name, 16 + random.nextInt(100))
                        : Scenes.named(name);
        if (random.nextBoolean()) return scene;
        var dull = scene.light().model().with(Reflection.LAMBERT);
        return lit(scene, new SceneLight(dull, scene.light().atEye()));
    }

    private static Scene lit(Scene scene, SceneLight light) {
        return PlannerTest.with(scene, light, scene.surfaces());
    }

    private static SphericalView camera(Scene scene, Random random) {
        SphericalView usual = scene.defaultCamera();
        return new SphericalView(
                6.28 * random.nextDouble(), 0.2 + 2.7 * random.nextDouble(), usual.rho());
    }

    private static RenderRequest seen(Scene scene, SphericalView camera, String method) {
        return new RenderRequest(scene, method, "phong", "perspective", camera, 160, 120);
    }
}
