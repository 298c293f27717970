package rasterlab.engine.pipeline.surface;

import static rasterlab.engine.scene.VertexQuantity.TEXTURE_S;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_T;

import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.texture.TextureSampler;

/**
 * A texture alone, as on opaque surfaces whose colours it replaces: asks for no light.
 *
 * <p>The level of detail is chosen for each pixel, from the slopes of its texture coordinates.
 */
public final class TexelPixels implements PixelColors {
    private static final Set<VertexQuantity> COORDINATES = EnumSet.of(TEXTURE_S, TEXTURE_T);

    private final TextureSampler sampler;
    private final TexelFilter filter;

    public TexelPixels(TextureSampler sampler, TexelFilter filter) {
        this.sampler = sampler;
        this.filter = filter;
    }

    @Override
    public Set<VertexQuantity> wants() {
        return COORDINATES;
    }

    @Override
    public Set<VertexQuantity> wantsSlopes() {
        return filter == TexelFilter.MIPMAP ? COORDINATES : Set.of();
    }

    @Override
    public Set<VertexQuantity> affine() {
        return filter == TexelFilter.AFFINE_NEAREST ? COORDINATES : Set.of();
    }

    @Override
    public void color(PixelBatch batch) {
        look(batch, batch.argb);
    }

    /** Finds the texels of the batch's pixels. */
    void look(PixelBatch batch, int[] texel) {
        float[] s = batch.values(TEXTURE_S);
        float[] t = batch.values(TEXTURE_T);
        switch (filter) {
            case MIPMAP -> sampler.trilinear(batch.count, s, t, squaredSteps(batch), texel);
            case LINEAR -> sampler.linear(batch.count, s, t, texel);
            case NEAREST, AFFINE_NEAREST -> sampler.nearest(batch.count, s, t, texel);
        }
    }

    private float[] squaredSteps(PixelBatch batch) {
        return batch.squaredSteps(sampler.texture().width(), sampler.texture().height());
    }
}
