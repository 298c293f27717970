package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.transform.SphericalView;

class PlanKeeperTest {
    private static final Tolerance TOLERANCE = new Tolerance(1, 6, 0);

    private final Planner planner = new Planner(1, Costs.measured());
    private final PlanKeeper keeper = new PlanKeeper(planner, TOLERANCE);
    private final Scene torus = Scenes.named("torus", 64);

    @Test
    void planIsKeptWhileItHolds() {
        Plan first = keeper.plan(seen(torus, 0, 96));
        assertSame(first, keeper.plan(seen(torus, 0.9 * first.range().turn(), 96)));
        assertNotSame(first, keeper.plan(seen(torus, 1.1 * first.range().turn(), 96)));
    }

    @Test
    void sceneThatIsMadeAnewForEachPictureKeepsItsPlan() {
        Plan first = keeper.plan(seen(torus.zoomed(1.5), 0, 96));
        assertSame(first, keeper.plan(seen(torus.zoomed(1.5), 0, 96)));
        assertNotSame(first, keeper.plan(seen(torus.zoomed(1.6), 0, 96)));
    }

    @Test
    void anotherPictureIsPlannedAnew() {
        Plan first = keeper.plan(seen(torus, 0, 96));
        Plan larger = keeper.plan(seen(torus, 0, 128));
        assertNotSame(first, larger);
        assertNotSame(larger, keeper.plan(seen(Scenes.named("torus", 64), 0, 128)));
    }

    @Test
    void mostPicturesOfAPathCostNoDecision() {
        var path = PlanPath.of(planner, seen(torus, 0, 96), TOLERANCE, 100);
        assertEquals(100, path.pictures());
        // 50 degrees round and a tenth nearer and farther.
        assertTrue(path.plans() >= 2 && path.plans() <= 12, path.toString());
        assertTrue(path.milliseconds() >= path.firstMilliseconds(), path.toString());
    }

    @ParameterizedTest(name = "along a path round {0} a picture leaves the tolerance, or jumps")
    @CsvSource({
        "torus, 64",
        "sphere, 320",
        "sphere-and-cylinder, 48",
        "globe, 40",
        "vase, 0",
        "house, 0",
        "near-plane, 0"
    })
    void plansOfALongPathFollowEachOtherWithoutAJump(String name, int detail) {
        Scene scene = detail > 0 ? Scenes.named(name, detail) : Scenes.named(name);
        SphericalView at = scene.defaultCamera();
        SphericalView last = at;
        Plan before = keeper.plan(from(scene, at));
        int changes = 0;
        try (var renderer = new Renderer()) {
            for (int k = 0; k < 45; k++) {
                double wave = Math.sin(0.3 * k);
                var camera =
                        new SphericalView(
                                at.thetaRadians() + 0.02 * k,
                                at.phiRadians() + 0.1 * wave,
                                at.rho() * (1 - 0.08 * wave));
                RenderRequest asked = from(scene, camera);
                Plan plan = keeper.plan(asked);
                Raster full = renderer.render(planner.full(asked), () -> false);
                within(full, renderer.render(plan.from(camera), () -> false), camera);
                if (plan != before && plan.within(last)) {
                    changes++;
                    Raster old = renderer.render(before.from(last), () -> false);
                    within(old, renderer.render(plan.from(last), () -> false), last);
                }
                before = plan;
                last = camera;
            }
        }
        assertTrue(changes > 0, "no plan was followed by another");
    }

    private static void within(Raster one, Raster other, SphericalView camera) {
        ToleratedDifference error = ToleratedDifference.of(one, other, TOLERANCE);
        assertTrue(error.within(TOLERANCE), camera + ": " + error);
    }

    private static RenderRequest seen(Scene scene, double turned, int width) {
        SphericalView at = scene.defaultCamera();
        var camera = new SphericalView(at.thetaRadians() + turned, at.phiRadians(), at.rho());
        return new RenderRequest(
                scene, "pipeline", "phong", "perspective", camera, width, width * 3 / 4);
    }

    private static RenderRequest from(Scene scene, SphericalView camera) {
        return new RenderRequest(scene, "pipeline", "phong", "perspective", camera, 240, 180);
    }
}
