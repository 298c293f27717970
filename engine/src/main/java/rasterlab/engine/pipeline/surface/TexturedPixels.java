package rasterlab.engine.pipeline.surface;

import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureSampler;

/**
 * A texture over the colours of other pixels: flat, Gouraud's ({@link ColoredPixels}) or Phong's
 * ({@link LitPixels}).
 */
public final class TexturedPixels implements PixelColors {
    private final TexelPixels texels;
    private final TextureEnvironment environment;
    private final PixelColors under;
    private final Set<VertexQuantity> wants;
    private final ThreadLocal<int[]> found =
            ThreadLocal.withInitial(() -> new int[PixelBatch.SIZE]);

    private TexturedPixels(TexelPixels texels, TextureEnvironment environment, PixelColors under) {
        this.texels = texels;
        this.environment = environment;
        this.under = under;
        wants = EnumSet.copyOf(texels.wants());
        wants.addAll(under.wants());
    }

    /**
     * @param under gives the colours that the texels are mixed with; it wants no texture
     *     coordinates
     */
    public TexturedPixels(
            TextureSampler sampler,
            TexelFilter filter,
            TextureEnvironment environment,
            PixelColors under) {
        this(new TexelPixels(sampler, filter), environment, under);
    }

    @Override
    public Set<VertexQuantity> wants() {
        return wants;
    }

    @Override
    public Set<VertexQuantity> wantsSlopes() {
        return texels.wantsSlopes();
    }

    @Override
    public Set<VertexQuantity> affine() {
        return texels.affine();
    }

    @Override
    public void color(PixelBatch batch) {
        int[] texel = found.get();
        texels.look(batch, texel);
        under.color(batch);
        environment.combine(batch.count, batch.argb, texel);
    }
}
