package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.scene.ExactSurfaces;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.transform.SphericalView;

class PlannerTest {
    private final Planner planner = new Planner(2, Costs.measured());

    @ParameterizedTest(name = "plans of {0} leave the tolerance")
    @MethodSource("rasterlab.engine.scene.catalogue.Scenes#names")
    void plannedPictureIsWithinTheTolerance(String name) {
        var random = new Random(name.hashCode());
        for (int k = 0; k < 4; k++) {
            Scene scene = Scenes.named(name);
            var tolerance =
                    new Tolerance(
                            0.1 * Math.pow(50, random.nextDouble()), 1 + random.nextInt(8), 0);
            RenderRequest asked = seen(scene, camera(scene, random), 96, 72);
            PlanTrial trial = PlanTrial.of(planner, asked, tolerance, 1, () -> false);
            assertTrue(
                    trial.error().within(tolerance),
                    () -> name + " from " + asked.camera() + " within " + tolerance + ": " + trial);
        }
    }

    @ParameterizedTest(name = "light of {0} in {1} steps mixed within {2} levels is off by more")
    @CsvSource({
        "sphere, 20, 2",
        "sphere, 28, 3",
        "sphere, 40, 1",
        "torus, 32, 8",
        "torus, 64, 3",
        "globe, 32, 4",
        "globe, 24, 6",
        "revolution, 40, 6",
        "revolution, 24, 3",
        "sphere-and-cylinder, 20, 3"
    })
    void mixedLightKeepsItsBound(String name, int detail, int levels) {
        Scene scene = Scenes.named(name, detail);
        var random = new Random(levels);
        long mixed = 0;
        for (int k = 0; k < 3; k++) {
            RenderRequest exact = seen(scene, camera(scene, random), 160, 120);
            Look saving = exact.look().withSavings(new Savings(levels, false));
            try (var renderer = new Renderer()) {
                var difference =
                        PictureDifference.of(
                                renderer.render(exact, () -> false),
                                renderer.render(exact.with(saving), () -> false));
                assertTrue(
                        difference.largestLevelDifference() <= levels,
                        difference.largestLevelDifference() + " levels");
                mixed += difference.wrongPixels();
            }
        }
        assertTrue(mixed > 0, "no light is mixed");
    }

    /** Places where a back comes out nearer than its front, or just as near. */
    @ParameterizedTest(name = "{0} in detail {1} without backs from {4}, {5}, {6}")
    @CsvSource({
        "sphere, 64, 93, 69, 3.4238308894522738, 2.4200393124342865, 1027.8380309121853",
        "sphere, 64, 366, 274, 4.237097195957427, 1.6840824457031405, 450.2162766746782",
        "sphere, 27, 93, 69, 5.812046913264148, 1.2440956310686964, 791.7046770565545",
        "globe, 45, 193, 144, 2.6326748253275922, 0.27967813580677364, 951.1807806675922",
        "globe, 302, 330, 247, 2.647176021538647, 0.5757916304226871, 745.1739440031499",
        "torus, 177, 108, 81, 0.3490658503988659, 0.85, 500",
        "cyclic-overlap, 0, 255, 191, 0.3066620758386683, 0.5539450486425487, 519.7448881458766",
        "cube, 0, 120, 90, 0.5, 1.1, 500"
    })
    void closedBodiesLookTheSameWithoutTheirBacks(
            String name, int detail, int width, int height, double theta, double phi, double rho) {
        Scene scene = detail > 0 ? Scenes.named(name, detail) : Scenes.named(name);
        RenderRequest all = seen(scene, new SphericalView(theta, phi, rho), width, height);
        Look fronts = all.look().withSavings(new Savings(0, true));
        try (var renderer = new Renderer()) {
            assertArrayEquals(
                    renderer.render(all, () -> false).argb(),
                    renderer.render(all.with(fronts), () -> false).argb());
        }
    }

    @ParameterizedTest(name = "{0} in detail {1}, {3} px, {4} levels, seen from {5}, {6}, {7}")
    @CsvSource({
        "sphere, 64, 93, 1, 8, 3.4238308894522738, 2.4200393124342865, 1027.8380309121853",
        "sphere, 64, 366, 1, 8, 4.237097195957427, 1.6840824457031405, 450.2162766746782",
        "sphere, 64, 236, 1, 8, 4.248591229570669, 0.5956030579539585, 668.2401150078645",
        "globe, 45, 193, 1, 6, 2.6326748253275922, 0.27967813580677364, 951.1807806675922",
        "textured-quad, 38, 294, 2.142, 4, 0.35, 1.1, 560",
        "textured-quad, 20, 80, 1, 2, 0.35, 1.1, 560",
        "sphere-and-cylinder, 32, 142, 1, 5, 2.059854458156216, 2.6969675637978585,"
                + " 619.5922441688144"
    })
    void rarePixelsStayWithinTheTolerance(
            String name,
            int detail,
            int width,
            double pixels,
            int levels,
            double theta,
            double phi,
            double rho) {
        Scene scene = Scenes.named(name, detail);
        int height = width * 3 / 4;
        RenderRequest asked = seen(scene, new SphericalView(theta, phi, rho), width, height);
        var tolerance = new Tolerance(pixels, levels, 0);
        Plan plan = planner.plan(asked, tolerance);
        Look mixed = plan.full().look().withSavings(new Savings(levels, false));
        try (var renderer = new Renderer()) {
            var full = renderer.render(plan.full(), () -> false);
            var least = renderer.render(plan.from(asked.camera()), () -> false);
            var light = renderer.render(plan.full().with(mixed), () -> false);
            assertEquals(
                    0,
                    ToleratedDifference.of(full, least, tolerance).wrong(),
                    plan.decisions().toString());
            assertEquals(0, ToleratedDifference.of(full, light, tolerance).wrong(), "mixed light");
        }
    }

    @Test
    void fewerFacesAreEnoughForLooserTolerances() {
        Scene torus = Scenes.named("torus", 200);
        RenderRequest asked = seen(torus, torus.defaultCamera(), 160, 120);
        int all = torus.mesh().faceCount();
        int strict = faces(planner.plan(asked, new Tolerance(0.1, 250, 0)));
        int loose = faces(planner.plan(asked, new Tolerance(2, 250, 0)));
        assertTrue(strict <= all && loose < strict, all + ", " + strict + ", " + loose);
    }

    @Test
    void whatIsOutOfSightIsLeftOut() {
        Scene scene = Scenes.named("sphere-and-cylinder", 200).zoomed(60);
        Plan plan =
                planner.plan(
                        seen(scene, new SphericalView(0.5, 1.05, 500), 96, 72),
                        new Tolerance(1, 4, 0));
        assertTrue(
                plan.decisions().stream().anyMatch(d -> d.subject().equals("sight")),
                plan.decisions().toString());
    }

    @ParameterizedTest(name = "a plan of {0} is made for a gain that another machine may not have")
    @MethodSource("rasterlab.engine.scene.catalogue.Scenes#names")
    void plansSaveATwentiethOrNothing(String name) {
        Scene scene = Scenes.named(name);
        var random = new Random(name.hashCode());
        for (int k = 0; k < 4; k++) {
            RenderRequest asked = seen(scene, camera(scene, random), 96, 72);
            Plan plan = planner.plan(asked, new Tolerance(1, 4, 0));
            double least = plan.cost().milliseconds();
            if (plan.saves())
                assertTrue(least <= 0.95 * plan.fullCost().milliseconds(), plan.toString());
            else assertEquals(plan.full(), plan.least(), plan.decisions().toString());
        }
    }

    @Test
    void backsOfOpenMeshesAreCountedAsSeen() {
        Scene quad = Scenes.named("textured-quad", 8);
        var behind = new SphericalView(quad.defaultCamera().thetaRadians(), 2.2, 560);
        Plan plan = planner.plan(seen(quad, behind, 96, 72), new Tolerance(0.1, 1, 0));
        long lit = WorkCount.of(plan.full(), () -> false).pixelLights();
        assertTrue(lit > 0, "nothing is seen");
        assertEquals(lit, plan.fullCost().work().pixelLights(), 0.1 * lit);
    }

    @Test
    void backsThatAreDrawnBeforeFrontsAreCountedAsLit() {
        Scene torus = Scenes.named("torus");
        Plan plan =
                planner.plan(
                        seen(torus, torus.defaultCamera(), 160, 120), new Tolerance(0.5, 4, 0));
        long lit = WorkCount.of(plan.full(), () -> false).pixelLights();
        assertEquals(lit, plan.fullCost().work().pixelLights(), 0.2 * lit);
        assertTrue(plan.least().look().savings().frontsOnly(), plan.decisions().toString());
    }

    @Test
    void facesAtTheOutlineAreCountedAsDrawn() {
        Scene sphere = Scenes.named("sphere", 12);
        RenderRequest asked = seen(sphere, sphere.defaultCamera(), 32, 24);
        Plan plan = planner.plan(asked, new Tolerance(0.1, 1, 0));
        assertTrue(plan.least().look().savings().frontsOnly(), plan.decisions().toString());
        assertEquals(WorkCount.of(plan.least(), () -> false).faces(), plan.cost().work().faces());
    }

    @Test
    void planIsKeptWhileTheCameraIsNear() {
        Scene torus = Scenes.named("torus");
        SphericalView at = torus.defaultCamera();
        Plan plan = planner.plan(seen(torus, at, 96, 72), new Tolerance(1, 4, 0));
        var near = new SphericalView(at.thetaRadians() + 0.01, at.phiRadians(), at.rho() * 1.01);
        assertTrue(plan.within(near));
        assertEquals(near, plan.from(near).camera());
        double turn = plan.range().turn() + 0.01;
        var turned = new SphericalView(at.thetaRadians() + turn, at.phiRadians(), at.rho());
        var closer = new SphericalView(at.thetaRadians(), at.phiRadians(), at.rho() / 1.2);
        assertFalse(plan.within(turned));
        assertFalse(plan.within(closer));
        assertThrows(IllegalArgumentException.class, () -> plan.from(turned));
    }

    @ParameterizedTest(name = "the plan of {0} is kept where it does not hold")
    @CsvSource({
        "torus, 120",
        "sphere, 64",
        "sphere-and-cylinder, 48",
        "textured-quad, 70",
        "vase, 0",
        "house, 0"
    })
    void keptPlanStaysWithinTheTolerance(String name, int detail) {
        Scene scene = detail > 0 ? Scenes.named(name, detail) : Scenes.named(name);
        SphericalView at = scene.defaultCamera();
        var tolerance = new Tolerance(1, 6, 0);
        Plan plan = planner.plan(seen(scene, at, 160, 120), tolerance);
        double room = 1.4 * plan.range().turn();
        var random = new Random(7);
        try (var renderer = new Renderer()) {
            for (int k = 0; k < 12; k++) {
                var camera =
                        new SphericalView(
                                at.thetaRadians() + room * (random.nextDouble() - 0.5),
                                at.phiRadians() + room * (random.nextDouble() - 0.5),
                                at.rho() * (0.96 + 0.08 * random.nextDouble()));
                assertTrue(plan.within(camera), camera.toString());
                RenderRequest full = planner.full(seen(scene, camera, 160, 120));
                ToleratedDifference error =
                        ToleratedDifference.of(
                                renderer.render(full, () -> false),
                                renderer.render(plan.from(camera), () -> false),
                                tolerance);
                assertTrue(error.within(tolerance), camera + ": " + error);
            }
        }
    }

    @Test
    void sceneThatOnlyLooksLikeAKnownOneIsPlannedAnew() {
        Scene torus = Scenes.named("torus", 100);
        var tolerance = new Tolerance(1, 6, 0);
        planner.plan(seen(torus, torus.defaultCamera(), 96, 72), tolerance);
        Scene near = torus.zoomed(3);
        Plan plan = planner.plan(seen(near, near.defaultCamera(), 96, 72), tolerance);
        assertEquals(near.pictureScale(), plan.least().scene().pictureScale());
    }

    @ParameterizedTest(name = "what is known of a torus outlives this change: {0}")
    @ValueSource(strings = {"a face less", "no surfaces", "glass", "lamps", "texture"})
    void nothingKnownOutlivesAChange(String change) {
        Scene torus = Scenes.named("torus", 40);
        var tolerance = new Tolerance(1, 6, 0);
        SphericalView at = torus.defaultCamera();
        var known = new Planner(1, Costs.measured());
        Plan before = known.plan(seen(torus, at, 96, 72), tolerance);
        assertTrue(before.least().look().savings().frontsOnly(), before.decisions().toString());
        RenderRequest asked = seen(changed(torus, change), at, 96, 72);
        Plan after = known.plan(asked, tolerance);
        Plan anew = new Planner(1, Costs.measured()).plan(asked, tolerance);
        assertEquals(anew.decisions(), after.decisions());
        assertNotEquals(before.decisions(), after.decisions());
    }

    private static Scene changed(Scene scene, String change) {
        return switch (change) {
            case "a face less" ->
                    scene.only(IntStream.range(1, scene.mesh().faceCount()).toArray());
            case "no surfaces" -> with(scene, scene.light(), Optional.empty());
            case "glass" -> scene.with(look -> Scenes.named("transparency").finishes().get(1));
            case "lamps" -> with(scene, SceneLight.lampAtEye(), scene.surfaces());
            default -> scene.with(look -> Scenes.named("globe").finishes().get(0));
        };
    }

    static Scene with(Scene scene, SceneLight light, Optional<ExactSurfaces> surfaces) {
        return new Scene(
                scene.name(),
                scene.mesh(),
                scene.finishes(),
                scene.finishOf(),
                light,
                scene.backgroundRgb(),
                scene.defaultCamera(),
                scene.pictureScale(),
                surfaces);
    }

    @ParameterizedTest(name = "all faces of {0} in {1} steps are asked or not, {2}×{2} pixels")
    @CsvSource({
        "revolution, 160, 400, false",
        "revolution, 160, 1200, true",
        "sphere, 120, 400, false",
        "sphere, 120, 1200, true"
    })
    void facesAreAskedWhereThatIsAPartOfThePicture(
            String name, int detail, int width, boolean asked) {
        Scene scene = Scenes.named(name, detail);
        RenderRequest picture = seen(scene, scene.defaultCamera(), width, width);
        Plan plan = planner.plan(picture, new Tolerance(0.001, 20, 0));
        assertEquals(
                asked,
                plan.decisions().stream().noneMatch(d -> d.reason().key().equals("unasked")),
                plan.decisions().toString());
    }

    private static int faces(Plan plan) {
        return plan.least().scene().mesh().faceCount();
    }

    private static SphericalView camera(Scene scene, Random random) {
        SphericalView usual = scene.defaultCamera();
        return new SphericalView(
                usual.thetaRadians() + 6.28 * random.nextDouble(),
                0.2 + 2.7 * random.nextDouble(),
                usual.rho() * (0.6 + 1.5 * random.nextDouble()));
    }

    private static RenderRequest seen(Scene scene, SphericalView camera, int width, int height) {
        return new RenderRequest(scene, "pipeline", "phong", "perspective", camera, width, height);
    }
}
