package rasterlab.engine.pipeline.surface;

import static rasterlab.engine.scene.VertexQuantity.ALPHA;
import static rasterlab.engine.scene.VertexQuantity.BLUE;
import static rasterlab.engine.scene.VertexQuantity.GREEN;
import static rasterlab.engine.scene.VertexQuantity.NORMAL_X;
import static rasterlab.engine.scene.VertexQuantity.NORMAL_Y;
import static rasterlab.engine.scene.VertexQuantity.NORMAL_Z;
import static rasterlab.engine.scene.VertexQuantity.RED;
import static rasterlab.engine.scene.VertexQuantity.X;
import static rasterlab.engine.scene.VertexQuantity.Y;
import static rasterlab.engine.scene.VertexQuantity.Z;

import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.BlockLighting;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.scene.VertexQuantity;

/**
 * The light of a whole scene on each pixel: Phong's way, with normals between those of the vertices
 * brought back to length 1.
 *
 * <p>Source: B. T. Phong, Illumination for computer generated pictures, Communications of the ACM
 * 18(6), 1975, pp. 311–317.
 */
public final class LitPixels implements PixelColors {
    private final ThreadLocal<Lit> lit;
    private final boolean tinted;
    private final boolean twoSided;
    private final Set<VertexQuantity> wants;

    /** The working memory of a thread. */
    private record Lit(PointShade shade, BlockLighting fronts) {}

    /**
     * @param lighting its lights and eye in eye space; where it stands now counts
     */
    public LitPixels(PointLighting lighting) {
        this(lighting, false);
    }

    /**
     * The light of a material whose emission, ambient and diffuse shares are multiplied by the
     * colours of the surface under this one.
     */
    public static LitPixels tinted(PointLighting lighting) {
        return new LitPixels(lighting, true);
    }

    private LitPixels(PointLighting lighting, boolean tinted) {
        PointLighting now = lighting.forThread();
        lit = ThreadLocal.withInitial(() -> new Lit(new PointShade(now), now.forBlocks()));
        twoSided = lighting.twoSided();
        this.tinted = tinted;
        wants = EnumSet.range(X, NORMAL_Z);
        if (tinted) wants.addAll(EnumSet.range(RED, ALPHA));
    }

    @Override
    public Set<VertexQuantity> wants() {
        return wants;
    }

    @Override
    public void color(PixelBatch batch) {
        Lit own = lit.get();
        if (tinted || twoSided) shadeEach(own.shade, batch);
        else shadeFronts(own.fronts, batch);
    }

    private void shadeEach(PointShade shade, PixelBatch batch) {
        float[] x = batch.values(X);
        float[] y = batch.values(Y);
        float[] z = batch.values(Z);
        float[] nx = batch.values(NORMAL_X);
        float[] ny = batch.values(NORMAL_Y);
        float[] nz = batch.values(NORMAL_Z);
        for (int i = 0; i < batch.count; i++) {
            shade.place(x[i], y[i], z[i], nx[i], ny[i], nz[i]);
            if (tinted) tinted(shade, batch, i);
            else shade.byMaterial(batch.fromBehind[i]);
            batch.argb[i] = Levels.argb(shade.rgba[0], shade.rgba[1], shade.rgba[2], shade.rgba[3]);
        }
    }

    private static void shadeFronts(BlockLighting fronts, PixelBatch batch) {
        int alpha = Levels.of(fronts.alpha()) << 24;
        for (int from = 0; from < batch.count; from += BlockLighting.SIZE) {
            int count = Math.min(BlockLighting.SIZE, batch.count - from);
            widen(batch.values(X), from, fronts.x, count);
            widen(batch.values(Y), from, fronts.y, count);
            widen(batch.values(Z), from, fronts.z, count);
            widen(batch.values(NORMAL_X), from, fronts.nx, count);
            widen(batch.values(NORMAL_Y), from, fronts.ny, count);
            widen(batch.values(NORMAL_Z), from, fronts.nz, count);
            fronts.light(count);
            for (int i = 0; i < count; i++)
                batch.argb[from + i] =
                        alpha
                                | level(fronts.red[i]) << 16
                                | level(fronts.green[i]) << 8
                                | level(fronts.blue[i]);
        }
    }

    /** {@link Levels#of} what is cut already. */
    private static int level(float share) {
        return (int) ((double) share * Levels.HIGHEST + 0.5);
    }

    private static void widen(float[] values, int from, double[] out, int count) {
        for (int i = 0; i < count; i++) out[i] = values[from + i];
    }

    private static void tinted(PointShade shade, PixelBatch batch, int i) {
        shade.tinted(
                batch.fromBehind[i],
                batch.values(RED)[i],
                batch.values(GREEN)[i],
                batch.values(BLUE)[i]);
    }
}
