package rasterlab.app.visibility;

import java.util.Optional;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * What the user chose, and what undo brings back.
 *
 * @param shown the scene
 * @param visibility a visibility method's name
 * @param comparison another one's beside it, "" for none
 * @param shading a shading's name
 * @param projection a projection's name
 * @param zoom picture scale as a multiple of the scene's own, {@value #SMALLEST} to {@value
 *     #LARGEST}
 * @param edges whether faces get edges, where the method draws any
 * @param difference whether the exact picture is compared
 * @param view what the stage shows
 * @param drawing whether the timeline goes through the method's steps; otherwise the scene turns
 * @param look all the rest
 */
public record VisibilityChoice(
        SceneChoice shown,
        String visibility,
        String comparison,
        String shading,
        String projection,
        SphericalView camera,
        double zoom,
        boolean edges,
        boolean difference,
        StageView view,
        boolean drawing,
        LookChoice look) {
    static final double SMALLEST = 0.25;
    static final double LARGEST = 32;

    private static final double FIRST_ZOOM = 1.6;

    public VisibilityChoice {
        if (!(zoom >= SMALLEST && zoom <= LARGEST))
            throw new IllegalArgumentException(
                    "zoom must be in [" + SMALLEST + ", " + LARGEST + "], got " + zoom);
    }

    /** The vase by the painter, as its author shades it. */
    static VisibilityChoice first() {
        SceneChoice vase = SceneChoice.named("vase");
        return new VisibilityChoice(
                vase,
                "painter",
                "",
                "tone",
                "perspective",
                vase.scene().defaultCamera(),
                FIRST_ZOOM,
                false,
                false,
                StageView.COLOURS,
                false,
                LookChoice.USUAL);
    }

    /** The scene's name, or its file's. */
    public String scene() {
        return shown.name();
    }

    /** Zooms by a factor; stops at the ends of the range. */
    VisibilityChoice zoomed(double factor) {
        double next = Math.max(SMALLEST, Math.min(LARGEST, zoom * factor));
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                projection,
                camera,
                next,
                edges,
                difference,
                view,
                drawing,
                look);
    }

    /** The scene as it is first shown, everything else kept that suits it. */
    VisibilityChoice withScene(String other) {
        return with(SceneChoice.named(other));
    }

    /** Another scene as it is first shown. */
    VisibilityChoice with(SceneChoice other) {
        return with(other, other.scene().defaultCamera());
    }

    VisibilityChoice with(SceneChoice other, SphericalView eye) {
        return new VisibilityChoice(
                other,
                visibility,
                comparison,
                shading,
                projection,
                eye,
                other.name().equals(shown.name()) ? zoom : usualZoom(other),
                edges,
                difference,
                view,
                drawing,
                suited(look, other));
    }

    /** The vase's own scale leaves room for every view; others fill the picture. */
    private static double usualZoom(SceneChoice scene) {
        return scene.name().equals("vase") ? FIRST_ZOOM : 1;
    }

    /** Decals need a texture with colours. */
    private static LookChoice suited(LookChoice look, SceneChoice scene) {
        boolean decal = look.change().environment().equals(Optional.of(Mode.DECAL));
        return decal && scene.fewestComponents() < 3
                ? look.withEnvironment(Optional.empty())
                : look;
    }

    VisibilityChoice withVisibility(String other) {
        return new VisibilityChoice(
                shown,
                other,
                comparison,
                shading,
                projection,
                camera,
                zoom,
                edges,
                difference,
                view,
                drawing,
                look);
    }

    VisibilityChoice withComparison(String other) {
        return new VisibilityChoice(
                shown,
                visibility,
                other,
                shading,
                projection,
                camera,
                zoom,
                edges,
                difference,
                view,
                drawing,
                look);
    }

    VisibilityChoice withShading(String other) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                other,
                projection,
                camera,
                zoom,
                edges,
                difference,
                view,
                drawing,
                look);
    }

    VisibilityChoice withProjection(String other) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                other,
                camera,
                zoom,
                edges,
                difference,
                view,
                drawing,
                look);
    }

    VisibilityChoice withCamera(SphericalView other) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                projection,
                other,
                zoom,
                edges,
                difference,
                view,
                drawing,
                look);
    }

    VisibilityChoice withEdges(boolean drawn) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                projection,
                camera,
                zoom,
                drawn,
                difference,
                view,
                drawing,
                look);
    }

    VisibilityChoice withDifference(boolean marked) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                projection,
                camera,
                zoom,
                edges,
                marked,
                view,
                drawing,
                look);
    }

    VisibilityChoice withView(StageView other) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                projection,
                camera,
                zoom,
                edges,
                difference,
                other,
                drawing,
                look);
    }

    VisibilityChoice withDrawing(boolean stepped) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                projection,
                camera,
                zoom,
                edges,
                difference,
                view,
                stepped,
                look);
    }

    VisibilityChoice with(LookChoice other) {
        return new VisibilityChoice(
                shown,
                visibility,
                comparison,
                shading,
                projection,
                camera,
                zoom,
                edges,
                difference,
                view,
                drawing,
                suited(other, shown));
    }

    /** The picture without edges, which are no matter of visibility. */
    RenderRequest plain(int width, int height) {
        return plain(visibility, width, height);
    }

    /** The same by another method. */
    RenderRequest plain(String method, int width, int height) {
        Scene zoomed = look.change().of(shown.scene().zoomed(zoom));
        Projection chosen = Projection.named(projection);
        return new RenderRequest(
                zoomed,
                camera,
                chosen,
                look.depths(chosen, camera.rho()),
                width,
                height,
                look.look(method, ShadingMethod.named(shading), chosen, camera.rho()));
    }
}
