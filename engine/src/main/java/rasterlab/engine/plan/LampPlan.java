package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.LightSource;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.Material;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.sight.Reason;

/**
 * Leaves out the lamps that together add less than the tolerance allows.
 *
 * <p>A lamp adds at most f·(kₐ·Lₐ + k_d·L_d + k_s·L_s) to a channel, f being its attenuation at the
 * point of the scene's box that is nearest to it; cosines and cones only take off that.
 */
final class LampPlan {
    /** The share of the level tolerance that lamps may use. */
    private static final double SHARE = 0.25;

    /** Levels that rounding may add where anything is left out. */
    private static final double ROOM = 0.5;

    private final Scene scene;
    private final double[] low = new double[3];
    private final double[] high = new double[3];

    /**
     * The scene with fewer lamps.
     *
     * @param levels that they may change
     */
    record FewerLamps(Scene scene, double levels) {}

    private record Faint(Light light, double levels) {}

    private LampPlan(Scene scene) {
        this.scene = scene;
        Mesh mesh = scene.mesh();
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
        }
        for (int v = 0; v < mesh.vertexCount(); v++) {
            double[] at = {mesh.x(v), mesh.y(v), mesh.z(v)};
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], at[axis]);
                high[axis] = Math.max(high[axis], at[axis]);
            }
        }
    }

    /**
     * @param tolerance levels that the whole plan may change
     * @param decisions gets what was decided
     */
    static FewerLamps of(Scene scene, double tolerance, List<PlanDecision> decisions) {
        List<Light> lights = scene.light().model().lights();
        if (lights.isEmpty() || scene.mesh().hasColors()) return new FewerLamps(scene, 0);
        var plan = new LampPlan(scene);
        List<Faint> faint =
                lights.stream()
                        .map(light -> new Faint(light, plan.most(light)))
                        .sorted(Comparator.comparingDouble(Faint::levels))
                        .toList();
        double sum = 0;
        List<Light> kept = new ArrayList<>(lights);
        for (Faint each : faint) {
            double next = sum + each.levels;
            if (next > 0 && !(next + ROOM <= SHARE * tolerance)) break;
            sum = next;
            kept.remove(each.light);
        }
        if (kept.size() == lights.size()) return new FewerLamps(scene, 0);
        int left = lights.size() - kept.size();
        double bound = sum > 0 ? sum + ROOM : 0;
        decisions.add(
                new PlanDecision(
                        "lamps",
                        Integer.toString(kept.size()),
                        Integer.toString(lights.size()),
                        Reason.of(
                                "faint",
                                "%d of %d lamps add at most %.2f levels together",
                                left,
                                lights.size(),
                                sum),
                        bound,
                        0));
        return new FewerLamps(plan.with(kept), bound);
    }

    /** The most that a lamp adds to a channel anywhere, in levels. */
    private double most(Light light) {
        LightSource source = light.source();
        double most =
                scene.finishes().stream()
                        .flatMap(finish -> Stream.of(finish.front(), finish.back()))
                        .map(Material::surface)
                        .mapToDouble(surface -> most(surface, source))
                        .max()
                        .orElse(0);
        return most == 0 ? 0 : 255 * most * strength(light);
    }

    private static double most(SurfaceMaterial surface, LightSource source) {
        double most = 0;
        for (int c = 0; c < 3; c++)
            most =
                    Math.max(
                            most,
                            surface.ambient()[c] * source.ambient()[c]
                                    + surface.diffuse()[c] * source.diffuse()[c]
                                    + surface.specular()[c] * source.specular()[c]);
        return most;
    }

    private double strength(Light light) {
        if (light.directional()) return 1;
        double[] at = {light.x(), light.y(), light.z()};
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double off = Math.max(0, Math.max(low[axis] - at[axis], at[axis] - high[axis]));
            square += off * off;
        }
        return light.source().attenuation().factor(Math.sqrt(square));
    }

    private Scene with(List<Light> lights) {
        LightModel model = scene.light().model();
        var fewer =
                new LightModel(
                        model.globalAmbient(),
                        model.localViewer(),
                        model.twoSided(),
                        model.reflection(),
                        lights);
        return new Scene(
                scene.name(),
                scene.mesh(),
                scene.finishes(),
                scene.finishOf(),
                new SceneLight(fewer, scene.light().atEye()),
                scene.backgroundRgb(),
                scene.defaultCamera(),
                scene.pictureScale(),
                scene.surfaces());
    }
}
