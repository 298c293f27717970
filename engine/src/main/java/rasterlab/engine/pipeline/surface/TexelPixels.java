package rasterlab.engine.pipeline.surface;

import static rasterlab.engine.scene.VertexQuantity.TEXTURE_S;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_T;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.TextureMatrix;
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
    private final Optional<TextureMatrix> matrix;

    private TexelPixels(
            TextureSampler sampler, TexelFilter filter, Optional<TextureMatrix> matrix) {
        this.sampler = sampler;
        this.filter = filter;
        this.matrix = matrix;
    }

    public TexelPixels(TextureSampler sampler, TexelFilter filter) {
        this(sampler, filter, Optional.empty());
    }

    /** The same with texture coordinates moved; what goes to infinity has any texel. */
    public TexelPixels moved(TextureMatrix by) {
        return new TexelPixels(sampler, filter, Optional.of(by));
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
        if (filter == TexelFilter.MIPMAP) {
            lookTrilinear(batch, s, t, texel);
            return;
        }
        if (matrix.isPresent()) matrix.get().transform(batch.count, s, t);
        if (filter == TexelFilter.LINEAR) sampler.linear(batch.count, s, t, texel);
        else sampler.nearest(batch.count, s, t, texel);
    }

    private void lookTrilinear(PixelBatch batch, float[] s, float[] t, int[] texel) {
        int width = sampler.texture().width();
        int height = sampler.texture().height();
        if (matrix.isEmpty()) {
            float[] squaredStep = batch.squaredSteps(width, height);
            sampler.trilinear(batch.count, s, t, squaredStep, texel);
            return;
        }
        float[] sRight = batch.right(TEXTURE_S);
        float[] tRight = batch.right(TEXTURE_T);
        float[] sDown = batch.down(TEXTURE_S);
        float[] tDown = batch.down(TEXTURE_T);
        matrix.get().transformSlopes(batch.count, s, t, sRight, tRight);
        matrix.get().transformSlopes(batch.count, s, t, sDown, tDown);
        matrix.get().transform(batch.count, s, t);
        DetailLevel.squareSteps(batch.count, sRight, tRight, sDown, tDown, width, height);
        sampler.trilinear(batch.count, s, t, sRight, texel);
    }
}
