package rasterlab.engine.pipeline.triangle;

import java.util.Set;
import rasterlab.engine.scene.VertexQuantity;

/** Gives pixels their colours: light by Phong's way and textures plug in here. */
public interface PixelColors {
    /**
     * What is wanted of a pixel: {@code X, Y, Z} in eye space; the normal in eye space, of any
     * length above 0; texture coordinates and colours as the mesh has them.
     */
    Set<VertexQuantity> wants();

    /**
     * Writes {@code argb} of the batch's pixels. Called by several threads at once, each with a
     * batch of its own.
     */
    void color(PixelBatch batch);
}
