package rasterlab.engine.pipeline.surface;

import static rasterlab.engine.scene.VertexQuantity.TEXTURE_S;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_T;

import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureMatrix;
import rasterlab.engine.texture.TextureSampler;

/** A texture with OpenGL's two filters over the colours of other pixels. */
public final class MinMagPixels implements PixelColors {
    private static final Set<VertexQuantity> COORDINATES = EnumSet.of(TEXTURE_S, TEXTURE_T);

    private final TextureSampler sampler;
    private final MinMag filters;
    private final TextureEnvironment environment;
    private final TextureMatrix matrix;
    private final PixelColors under;
    private final boolean affine;
    private final Set<VertexQuantity> wants;
    private final ThreadLocal<int[]> texels =
            ThreadLocal.withInitial(() -> new int[PixelBatch.SIZE]);

    /**
     * @param matrix moves texture coordinates; what goes to infinity has any texel
     * @param affine whether the coordinates are linear on the picture, which is wrong in
     *     perspective
     * @param under gives the colours that the texels are mixed with; it wants no texture
     *     coordinates
     */
    public MinMagPixels(
            TextureSampler sampler,
            MinMag filters,
            TextureEnvironment environment,
            TextureMatrix matrix,
            boolean affine,
            PixelColors under) {
        this.sampler = sampler;
        this.filters = filters;
        this.environment = environment;
        this.matrix = matrix;
        this.affine = affine;
        this.under = under;
        wants = EnumSet.copyOf(COORDINATES);
        wants.addAll(under.wants());
    }

    @Override
    public Set<VertexQuantity> wants() {
        return wants;
    }

    @Override
    public Set<VertexQuantity> wantsSlopes() {
        return COORDINATES;
    }

    @Override
    public Set<VertexQuantity> affine() {
        return affine ? COORDINATES : Set.of();
    }

    @Override
    public void color(PixelBatch batch) {
        int[] texel = texels.get();
        int count = batch.count;
        float[] s = batch.values(TEXTURE_S);
        float[] t = batch.values(TEXTURE_T);
        float[] sRight = batch.right(TEXTURE_S);
        float[] tRight = batch.right(TEXTURE_T);
        float[] sDown = batch.down(TEXTURE_S);
        float[] tDown = batch.down(TEXTURE_T);
        matrix.transformSlopes(count, s, t, sRight, tRight);
        matrix.transformSlopes(count, s, t, sDown, tDown);
        matrix.transform(count, s, t);
        int width = sampler.texture().width();
        int height = sampler.texture().height();
        DetailLevel.squareSteps(count, sRight, tRight, sDown, tDown, width, height);
        for (int i = 0; i < count; i++)
            texel[i] = filters.texel(sampler, s[i], t[i], DetailLevel.quick(sRight[i]));
        under.color(batch);
        environment.combine(count, batch.argb, texel);
    }
}
