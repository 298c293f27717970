package rasterlab.engine.pipeline.surface;

import static rasterlab.engine.scene.VertexQuantity.TEXTURE_S;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_T;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.pipeline.triangle.PixelBatch;
import rasterlab.engine.pipeline.triangle.PixelColors;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureMatrix;
import rasterlab.engine.texture.TextureSampler;

/**
 * A texture over the colours of other pixels: flat, Gouraud's ({@link ColoredPixels}) or Phong's
 * ({@link LitPixels}).
 *
 * <p>The level of detail is chosen for each pixel, from the slopes of its texture coordinates.
 */
public final class TexturedPixels implements PixelColors {
    private static final Set<VertexQuantity> COORDINATES = EnumSet.of(TEXTURE_S, TEXTURE_T);

    private final TextureSampler sampler;
    private final TextureFilter filter;
    private final TextureEnvironment environment;
    private final Optional<TextureMatrix> matrix;
    private final PixelColors under;
    private final Set<VertexQuantity> wants;
    private final ThreadLocal<int[]> texels =
            ThreadLocal.withInitial(() -> new int[PixelBatch.SIZE]);

    private TexturedPixels(
            TextureSampler sampler,
            TextureFilter filter,
            TextureEnvironment environment,
            Optional<TextureMatrix> matrix,
            PixelColors under) {
        this.sampler = sampler;
        this.filter = filter;
        this.environment = environment;
        this.matrix = matrix;
        this.under = under;
        wants = EnumSet.copyOf(COORDINATES);
        wants.addAll(under.wants());
    }

    /**
     * @param under gives the colours that the texels are mixed with; it wants no texture
     *     coordinates
     */
    public TexturedPixels(
            TextureSampler sampler,
            TextureFilter filter,
            TextureEnvironment environment,
            PixelColors under) {
        this(sampler, filter, environment, Optional.empty(), under);
    }

    /** The same with texture coordinates moved; what goes to infinity has any texel. */
    public TexturedPixels moved(TextureMatrix by) {
        return new TexturedPixels(sampler, filter, environment, Optional.of(by), under);
    }

    @Override
    public Set<VertexQuantity> wants() {
        return wants;
    }

    @Override
    public Set<VertexQuantity> wantsSlopes() {
        return filter == TextureFilter.MIPMAP ? COORDINATES : Set.of();
    }

    @Override
    public Set<VertexQuantity> affine() {
        return filter == TextureFilter.AFFINE_NEAREST ? COORDINATES : Set.of();
    }

    @Override
    public void color(PixelBatch batch) {
        int[] texel = texels.get();
        look(batch, texel);
        under.color(batch);
        environment.combine(batch.lanes(), batch.count, batch.argb, texel);
    }

    private void look(PixelBatch batch, int[] texel) {
        float[] s = batch.values(TEXTURE_S);
        float[] t = batch.values(TEXTURE_T);
        if (filter == TextureFilter.MIPMAP) {
            lookTrilinear(batch, s, t, texel);
            return;
        }
        if (matrix.isPresent()) matrix.get().transform(batch.count, s, t);
        if (filter == TextureFilter.LINEAR) sampler.linear(batch.lanes(), batch.count, s, t, texel);
        else sampler.nearest(batch.lanes(), batch.count, s, t, texel);
    }

    private void lookTrilinear(PixelBatch batch, float[] s, float[] t, int[] texel) {
        int width = sampler.texture().width();
        int height = sampler.texture().height();
        if (matrix.isEmpty()) {
            float[] squaredStep = batch.squaredSteps(width, height);
            sampler.trilinear(batch.lanes(), batch.count, s, t, squaredStep, texel);
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
        sampler.trilinear(batch.lanes(), batch.count, s, t, sRight, texel);
    }
}
