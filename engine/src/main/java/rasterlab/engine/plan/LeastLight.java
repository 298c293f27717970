package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.sight.Reason;

/**
 * A scene without the lamps and the terms of light that do not count.
 *
 * @param allowed levels of the whole plan
 * @param scene the rest
 * @param levels that what is left out may change
 * @param decisions what was left out
 */
record LeastLight(double allowed, Scene scene, double levels, List<PlanDecision> decisions) {
    LeastLight {
        decisions = List.copyOf(decisions);
    }

    static LeastLight of(Scene scene, double allowed) {
        List<PlanDecision> decisions = new ArrayList<>();
        LampPlan.FewerLamps lamps = LampPlan.of(scene, allowed, decisions);
        Scene rest = withoutDarkTerms(lamps.scene(), decisions);
        return new LeastLight(allowed, rest, lamps.levels(), decisions);
    }

    /** Whether the same place is lit alike wherever the eye is. */
    static boolean eyeFree(Scene scene) {
        return scene.light().atEye().isEmpty()
                && scene.light().model().reflection() == Reflection.LAMBERT;
    }

    /** Highlights are left out where neither a material nor a lamp has any. */
    private static Scene withoutDarkTerms(Scene scene, List<PlanDecision> decisions) {
        LightModel model = scene.light().model();
        boolean bright =
                Stream.concat(
                                model.lights().stream().map(Light::source),
                                scene.light().atEye().stream())
                        .anyMatch(source -> any(source.specular()));
        boolean mirror =
                scene.finishes().stream()
                        .flatMap(f -> Stream.of(f.front(), f.back()))
                        .anyMatch(material -> any(material.surface().specular()));
        if (model.reflection() == Reflection.LAMBERT || bright && mirror) return scene;
        decisions.add(
                PlanDecision.exact(
                        "terms",
                        "ambient, diffuse, emission",
                        "ambient, diffuse, specular, emission",
                        bright
                                ? Reason.of("dull", "no material mirrors light")
                                : Reason.of("lamps", "no lamp gives highlights")));
        return new Scene(
                scene.name(),
                scene.mesh(),
                scene.finishes(),
                scene.finishOf(),
                new SceneLight(model.with(Reflection.LAMBERT), scene.light().atEye()),
                scene.backgroundRgb(),
                scene.defaultCamera(),
                scene.pictureScale(),
                scene.surfaces());
    }

    private static boolean any(double[] shares) {
        return shares[0] > 0 || shares[1] > 0 || shares[2] > 0;
    }
}
