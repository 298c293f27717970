package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.sight.cost.Costs;

class LampPlanTest {
    private static final double[] AMBIENT = {0.2, 0.2, 0.2};

    @ParameterizedTest(name = "{0} faint lamps of {1} levels each, {2} allowed: {3} are left out")
    @CsvSource({
        "1, 0.5, 8, 1",
        "3, 0.4, 8, 3",
        "3, 0.7, 8, 2",
        "3, 0.7, 4, 0",
        "2, 0, 0, 2",
        "1, 1.6, 8, 0",
        "1, 200, 8, 0"
    })
    void lampsThatAddLittleAreLeftOut(int lamps, double each, double levels, int out) {
        Scene scene = lit(lamps, each);
        List<PlanDecision> decisions = new ArrayList<>();
        LampPlan.FewerLamps result = LampPlan.of(scene, levels, decisions);
        assertEquals(lamps + 1 - out, result.scene().light().model().lights().size());
        assertEquals(out > 0 ? 1 : 0, decisions.size());
        assertTrue(result.levels() <= levels, result.levels() + " of " + levels);
        assertTrue(out == 0 || result.levels() >= out * each, result.levels() + " for " + out);
    }

    @ParameterizedTest(name = "{0} faint lamps are seen to be missing")
    @CsvSource({"1, 1.4", "4, 0.3"})
    void pictureWithoutThemIsWithinTheTolerance(int lamps, double each) {
        Scene scene = lit(lamps, each);
        var asked =
                new RenderRequest(
                        scene, "pipeline", "phong", "perspective", scene.defaultCamera(), 96, 72);
        var tolerance = new Tolerance(0.5, 8, 0);
        var planner = new Planner(1, Costs.measured());
        PlanTrial trial = PlanTrial.of(planner, asked, tolerance, 1, () -> false);
        assertEquals(0, trial.steppedBack());
        assertTrue(trial.error().within(tolerance), trial.error().toString());
        assertEquals(1, trial.plan().least().scene().light().model().lights().size());
    }

    /**
     * A dull torus under a sun and lamps that add so many levels at most where they are nearest.
     */
    private static Scene lit(int lamps, double levels) {
        Scene torus = Scenes.named("torus", 24);
        double diffuse = 0;
        for (double share : torus.finishes().get(0).front().surface().diffuse())
            diffuse = Math.max(diffuse, share);
        double top = 0;
        for (int v = 0; v < torus.mesh().vertexCount(); v++) top = Math.max(top, torus.mesh().z(v));
        double[] none = new double[3];
        double[] white = {1, 1, 1};
        double distance = 1000;
        // 1/(q·d²) makes it so many levels at the top.
        double q = levels > 0 ? 255 * diffuse / (levels * distance * distance) : 1;
        var faint =
                new LightSource(
                        none,
                        levels > 0 ? white : none,
                        none,
                        new Attenuation(0, 0, q),
                        SpotCone.none());
        List<Light> lights = new ArrayList<>();
        lights.add(Light.from(LightSource.white(), 0.3, 0.2, 1));
        for (int k = 0; k < lamps; k++) lights.add(Light.at(faint, 0, 0, top + distance));
        var model = new LightModel(AMBIENT, false, false, Reflection.LAMBERT, lights);
        return new Scene(
                torus.name(),
                torus.mesh(),
                torus.finishes(),
                torus.finishOf(),
                new SceneLight(model, Optional.empty()),
                torus.backgroundRgb(),
                torus.defaultCamera(),
                torus.pictureScale(),
                torus.surfaces());
    }
}
