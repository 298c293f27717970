package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import rasterlab.engine.pipeline.RenderRequest;
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

    private static RenderRequest seen(Scene scene, double turned, int width) {
        SphericalView at = scene.defaultCamera();
        var camera = new SphericalView(at.thetaRadians() + turned, at.phiRadians(), at.rho());
        return new RenderRequest(
                scene, "pipeline", "phong", "perspective", camera, width, width * 3 / 4);
    }
}
