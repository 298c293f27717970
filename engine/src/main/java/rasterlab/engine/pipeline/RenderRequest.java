package rasterlab.engine.pipeline;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * What to draw and how; every name is known and every size allowed, or there is no request.
 *
 * @param scene what is looked at
 * @param visibility one of {@link Renderer#visibilities()}
 * @param shading one of {@link Renderer#shadings()}
 * @param projection "perspective" or "parallel"
 * @param camera the view; one that stands on its head is drawn upright
 * @param width 1 to 8192 pixels
 * @param height 1 to 8192 pixels
 * @param outline whether faces get edges of 0.96 of their tone; painters only
 */
public record RenderRequest(
        Scene scene,
        String visibility,
        String shading,
        String projection,
        SphericalView camera,
        int width,
        int height,
        boolean outline) {
    public RenderRequest {
        Renderer.checkNames(visibility, shading, outline);
        Projection.named(projection);
        Raster.checkSize(width, height);
    }

    /** A request without outlines. */
    public RenderRequest(
            Scene scene,
            String visibility,
            String shading,
            String projection,
            SphericalView camera,
            int width,
            int height) {
        this(scene, visibility, shading, projection, camera, width, height, false);
    }

    /**
     * The same picture with outlined faces.
     *
     * @throws IllegalArgumentException if the visibility method draws none
     */
    public RenderRequest withOutline() {
        return new RenderRequest(
                scene, visibility, shading, projection, camera, width, height, true);
    }

    /** The same picture by another visibility method. */
    public RenderRequest withVisibility(String other) {
        return new RenderRequest(scene, other, shading, projection, camera, width, height, outline);
    }
}
