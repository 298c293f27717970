package rasterlab.app.visibility;

import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

/**
 * What the user chose, and what undo brings back.
 *
 * @param scene a name of {@link Scenes}
 * @param visibility a visibility method's name
 * @param shading a shading's name
 * @param projection a projection's name
 * @param zoom picture scale as a multiple of the scene's own, {@value #SMALLEST} to {@value
 *     #LARGEST}
 * @param edges whether faces get edges, where the method draws any
 * @param difference whether the exact picture is compared
 */
public record VisibilityChoice(
        String scene,
        String visibility,
        String shading,
        String projection,
        SphericalView camera,
        double zoom,
        boolean edges,
        boolean difference) {
    static final double SMALLEST = 0.25;
    static final double LARGEST = 32;

    public VisibilityChoice {
        if (!(zoom >= SMALLEST && zoom <= LARGEST))
            throw new IllegalArgumentException(
                    "zoom must be in [" + SMALLEST + ", " + LARGEST + "], got " + zoom);
    }

    /** Zooms by a factor; stops at the ends of the range. */
    VisibilityChoice zoomed(double factor) {
        double next = Math.max(SMALLEST, Math.min(LARGEST, zoom * factor));
        return new VisibilityChoice(
                scene, visibility, shading, projection, camera, next, edges, difference);
    }

    /** The scene as it is first shown, everything else kept. */
    VisibilityChoice withScene(String other) {
        Scene found = Scenes.named(other);
        return new VisibilityChoice(
                other,
                visibility,
                shading,
                projection,
                found.defaultCamera(),
                zoom,
                edges,
                difference);
    }

    VisibilityChoice withVisibility(String other) {
        return new VisibilityChoice(
                scene, other, shading, projection, camera, zoom, edges, difference);
    }

    VisibilityChoice withShading(String other) {
        return new VisibilityChoice(
                scene, visibility, other, projection, camera, zoom, edges, difference);
    }

    VisibilityChoice withProjection(String other) {
        return new VisibilityChoice(
                scene, visibility, shading, other, camera, zoom, edges, difference);
    }

    VisibilityChoice withCamera(SphericalView other) {
        return new VisibilityChoice(
                scene, visibility, shading, projection, other, zoom, edges, difference);
    }

    VisibilityChoice withEdges(boolean shown) {
        return new VisibilityChoice(
                scene, visibility, shading, projection, camera, zoom, shown, difference);
    }

    VisibilityChoice withDifference(boolean shown) {
        return new VisibilityChoice(
                scene, visibility, shading, projection, camera, zoom, edges, shown);
    }

    /** The picture without edges, which are no matter of visibility. */
    RenderRequest plain(int width, int height) {
        Scene zoomed = Scenes.named(scene).zoomed(zoom);
        return new RenderRequest(zoomed, visibility, shading, projection, camera, width, height);
    }
}
