package rasterlab.app.visibility;

import java.util.Optional;
import rasterlab.app.model.TextureChange;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.transform.Projection;
import rasterlab.exercises.scene.Setting;
import rasterlab.exercises.scene.Settings;

/** How the lab draws a scene, as a scene file says it: lengths are world units, not shares of ρ. */
final class SavedView {
    private SavedView() {}

    /** All but the scene and a picture laid on its faces. */
    static Settings of(VisibilityChoice choice) {
        LookChoice look = choice.look();
        double rho = choice.camera().rho();
        Settings said =
                Settings.NONE
                        .with(Setting.CAMERA, choice.camera())
                        .with(Setting.PROJECTION, Projection.named(choice.projection()))
                        .with(Setting.ZOOM, choice.zoom())
                        .with(Setting.VISIBILITY, VisibilityChoice.known(choice.visibility()))
                        .with(Setting.SHADING, ShadingMethod.named(choice.shading()))
                        .with(Setting.TEXTURE, look.texture())
                        .with(Setting.WRAP, look.change().wrap())
                        .with(Setting.ENVIRONMENT, look.change().environment())
                        .with(Setting.TERMS, look.terms())
                        .with(Setting.CULL, look.cull())
                        .with(Setting.HIDDEN_LINES, look.hidden())
                        .with(Setting.CREASE, look.crease())
                        .with(Setting.OUTLINE, choice.edges())
                        .with(Setting.STEREO, look.stereo())
                        .with(Setting.EYES, look.eyes() * rho);
        if (look.sides() != Sides.SCENE)
            said = said.with(Setting.TWO_SIDED, look.sides() == Sides.TWO);
        if (look.cue() > 0) said = said.with(Setting.DEPTH_CUE, new DepthCue(look.cue()));
        if (look.near() > 0) said = said.with(Setting.NEAR, look.near() * rho);
        if (look.far() < Double.POSITIVE_INFINITY) said = said.with(Setting.FAR, look.far() * rho);
        return look.clipPlanes().isEmpty()
                ? said
                : said.with(Setting.CLIP_PLANES, look.clipPlanes());
    }

    /**
     * A scene as its file says. The look is the usual one where the file says nothing; the methods
     * and the projection are then those of the choice.
     *
     * @throws IllegalArgumentException for what the lab cannot show
     */
    static VisibilityChoice applied(VisibilityChoice choice, SceneChoice scene, Settings said) {
        VisibilityChoice next = choice.with(scene);
        next = next.withCamera(said.get(Setting.CAMERA).orElse(next.camera()));
        double rho = next.camera().rho();
        return next.withZoom(said.get(Setting.ZOOM).orElse(next.zoom()))
                .withProjection(
                        said.get(Setting.PROJECTION)
                                .map(Projection::code)
                                .orElse(next.projection()))
                .withVisibility(said.get(Setting.VISIBILITY).orElse(next.visibility()))
                .withShading(
                        said.get(Setting.SHADING).map(ShadingMethod::code).orElse(next.shading()))
                .withEdges(said.get(Setting.OUTLINE).orElse(false))
                .with(look(said, rho));
    }

    private static LookChoice look(Settings said, double rho) {
        LookChoice usual = LookChoice.USUAL;
        return new LookChoice(
                said.get(Setting.TEXTURE).orElse(usual.texture()),
                new TextureChange(said.get(Setting.WRAP), said.get(Setting.ENVIRONMENT)),
                said.get(Setting.TERMS).orElse(usual.terms()),
                said.get(Setting.TWO_SIDED)
                        .map(two -> two ? Sides.TWO : Sides.ONE)
                        .orElse(Sides.SCENE),
                said.get(Setting.CULL).orElse(usual.cull()),
                said.get(Setting.HIDDEN_LINES).orElse(usual.hidden()),
                said.get(Setting.CREASE).orElse(usual.crease()),
                said.get(Setting.DEPTH_CUE).map(DepthCue::strength).orElse(usual.cue()),
                said.get(Setting.STEREO),
                share(said.get(Setting.EYES), rho).orElse(usual.eyes()),
                share(said.get(Setting.NEAR), rho).orElse(usual.near()),
                share(said.get(Setting.FAR), rho).orElse(usual.far()),
                said.get(Setting.CLIP_PLANES).orElse(usual.clipPlanes()));
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
