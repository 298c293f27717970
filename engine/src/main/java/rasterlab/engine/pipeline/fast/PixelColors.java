package rasterlab.engine.pipeline.fast;

import java.util.Set;
import rasterlab.engine.scene.VertexQuantity;

/** Gives pixels their colours: light by Phong's way and textures plug in here. */
public interface PixelColors {
    /**
     * The quantities that are wanted of a pixel: {@code X, Y, Z} in eye space; the normal in eye
     * space, of any length above 0; texture coordinates as the mesh has them; colours of the
     * vertices, 0 to 1, as {@link Surface.PerPixel#under} makes them, but alpha is 1 where nothing
     * depends on it.
     */
    Set<VertexQuantity> wants();

    /** The wanted quantities whose slopes on the picture are wanted too. */
    default Set<VertexQuantity> wantsSlopes() {
        return Set.of();
    }

    /** The quantities that shall be linear on the picture, which is wrong in perspective. */
    default Set<VertexQuantity> affine() {
        return Set.of();
    }

    /**
     * The quantities that are only directions: each pixel's may come all of them times the same
     * number above 0. They want no slopes.
     */
    default Set<VertexQuantity> directions() {
        return Set.of();
    }

    /**
     * Writes {@code argb} of the batch's pixels. Called by several threads at once, each with a
     * batch of its own.
     */
    void color(PixelBatch batch);
}
