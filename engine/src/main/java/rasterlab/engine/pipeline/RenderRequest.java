package rasterlab.engine.pipeline;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * A request for a picture: what to draw and how; every name is known and every size allowed, or
 * there is no request.
 *
 * @param scene what is looked at
 * @param camera the view; one that stands on its head is drawn upright
 * @param projection to the picture plane
 * @param depth what is near and far enough to be drawn
 * @param width 1 to 8192 pixels
 * @param height 1 to 8192 pixels
 * @param look how
 */
public record RenderRequest(
        Scene scene,
        SphericalView camera,
        Projection projection,
        DrawnDepths depth,
        int width,
        int height,
        Look look) {
    public RenderRequest {
        Raster.checkSize(width, height);
        depth.require(projection, camera.rho());
        if (look.stereo().isPresent()) Eyes.require(look.stereo().get(), projection, camera, width);
    }

    /** A request with the usual depths and look. */
    public RenderRequest(
            Scene scene,
            String visibility,
            String shading,
            String projection,
            SphericalView camera,
            int width,
            int height) {
        this(
                scene,
                camera,
                Projection.named(projection),
                DrawnDepths.all(Projection.named(projection), camera.rho()),
                width,
                height,
                Look.of(visibility, ShadingMethod.named(shading)));
    }

    /** This view with another look. */
    public RenderRequest with(Look other) {
        return new RenderRequest(scene, camera, projection, depth, width, height, other);
    }

    /** This picture from another camera; the usual depths go with its distance. */
    public RenderRequest from(SphericalView other) {
        boolean usual = depth.equals(DrawnDepths.all(projection, camera.rho()));
        DrawnDepths depths = usual ? DrawnDepths.all(projection, other.rho()) : depth;
        return new RenderRequest(scene, other, projection, depths, width, height, look);
    }

    /** This picture of another scene. */
    public RenderRequest with(Scene other) {
        return new RenderRequest(other, camera, projection, depth, width, height, look);
    }

    /**
     * This picture with outlined faces.
     *
     * @throws IllegalArgumentException if the visibility method draws none
     */
    public RenderRequest withOutline() {
        return with(look.withOutline());
    }

    /** This picture by another visibility method. */
    public RenderRequest withVisibility(String other) {
        return with(look.withVisibility(other));
    }

    /** This picture with other light. */
    public RenderRequest withShading(ShadingMethod other) {
        return with(look.withShading(other));
    }

    /** The name of the visibility method. */
    public String visibility() {
        return look.visibility();
    }
}
