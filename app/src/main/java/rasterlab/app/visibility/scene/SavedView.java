package rasterlab.app.visibility.scene;

import java.util.Optional;
import rasterlab.app.model.TextureChange;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.transform.Projection;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.Settings;

/** How the lab draws a scene, as a scene file says it: lengths are world units, not shares of ρ. */
final class SavedView {
    private SavedView() {}

    /** The settings of the view, without the scene and a picture laid on its faces. */
    static Settings of(VisibilityChoice choice) {
        LookChoice look = choice.look();
        double rho = choice.camera().rho();
        Settings said =
                Settings.NONE
                        .with(SceneSetting.CAMERA, choice.camera())
                        .with(SceneSetting.PROJECTION, Projection.named(choice.projection()))
                        .with(SceneSetting.ZOOM, choice.zoom())
                        .with(SceneSetting.VISIBILITY, VisibilityChoice.known(choice.visibility()))
                        .with(SceneSetting.SHADING, ShadingMethod.named(choice.shading()))
                        .with(SceneSetting.TEXTURE, look.texture())
                        .with(SceneSetting.WRAP, look.change().wrap())
                        .with(SceneSetting.ENVIRONMENT, look.change().environment())
                        .with(SceneSetting.TERMS, look.terms())
                        .with(SceneSetting.CULL, look.cull())
                        .with(SceneSetting.HIDDEN_LINES, look.hidden())
                        .with(SceneSetting.CREASE, look.crease())
                        .with(SceneSetting.OUTLINE, choice.edges())
                        .with(SceneSetting.STEREO, look.stereo())
                        .with(SceneSetting.EYES, look.eyes() * rho);
        if (look.sides() != Sides.SCENE)
            said = said.with(SceneSetting.TWO_SIDED, look.sides() == Sides.TWO);
        if (look.cue() > 0) said = said.with(SceneSetting.DEPTH_CUE, new DepthCue(look.cue()));
        if (look.near() > 0) said = said.with(SceneSetting.NEAR, look.near() * rho);
        if (look.far() < Double.POSITIVE_INFINITY)
            said = said.with(SceneSetting.FAR, look.far() * rho);
        return look.clipPlanes().isEmpty()
                ? said
                : said.with(SceneSetting.CLIP_PLANES, look.clipPlanes());
    }

    /**
     * A scene as its file says. The look is the usual one where the file says nothing; the methods
     * and the projection are then those of the choice.
     *
     * @throws IllegalArgumentException for what the lab cannot show
     */
    static VisibilityChoice applied(VisibilityChoice choice, SceneChoice scene, Settings said) {
        VisibilityChoice next = choice.with(scene);
        next = next.withCamera(said.get(SceneSetting.CAMERA).orElse(next.camera()));
        double rho = next.camera().rho();
        return next.withZoom(said.get(SceneSetting.ZOOM).orElse(next.zoom()))
                .withProjection(
                        said.get(SceneSetting.PROJECTION)
                                .map(Projection::code)
                                .orElse(next.projection()))
                .withVisibility(said.get(SceneSetting.VISIBILITY).orElse(next.visibility()))
                .withShading(
                        said.get(SceneSetting.SHADING)
                                .map(ShadingMethod::code)
                                .orElse(next.shading()))
                .withEdges(said.get(SceneSetting.OUTLINE).orElse(false))
                .with(look(said, rho));
    }

    private static LookChoice look(Settings said, double rho) {
        LookChoice usual = LookChoice.USUAL;
        return new LookChoice(
                said.get(SceneSetting.TEXTURE).orElse(usual.texture()),
                new TextureChange(said.get(SceneSetting.WRAP), said.get(SceneSetting.ENVIRONMENT)),
                said.get(SceneSetting.TERMS).orElse(usual.terms()),
                said.get(SceneSetting.TWO_SIDED)
                        .map(two -> two ? Sides.TWO : Sides.ONE)
                        .orElse(Sides.SCENE),
                said.get(SceneSetting.CULL).orElse(usual.cull()),
                said.get(SceneSetting.HIDDEN_LINES).orElse(usual.hidden()),
                said.get(SceneSetting.CREASE).orElse(usual.crease()),
                said.get(SceneSetting.DEPTH_CUE).map(DepthCue::strength).orElse(usual.cue()),
                said.get(SceneSetting.STEREO),
                share(said.get(SceneSetting.EYES), rho).orElse(usual.eyes()),
                share(said.get(SceneSetting.NEAR), rho).orElse(usual.near()),
                share(said.get(SceneSetting.FAR), rho).orElse(usual.far()),
                said.get(SceneSetting.CLIP_PLANES).orElse(usual.clipPlanes()));
    }

    /** The share of ρ that gives the units back, where rounding leaves one. */
    private static Optional<Double> share(Optional<Double> units, double rho) {
        return units.map(
                all -> {
                    double share = all / rho;
                    for (double s : new double[] {Math.nextUp(share), Math.nextDown(share)})
                        if (share * rho != all && s * rho == all) return s;
                    return share;
                });
    }
}
