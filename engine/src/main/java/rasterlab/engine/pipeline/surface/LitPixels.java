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
    private final ThreadLocal<PointShade> shades;
    private final boolean tinted;
    private final Set<VertexQuantity> wants;

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
        shades = ThreadLocal.withInitial(() -> new PointShade(now));
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
        PointShade shade = shades.get();
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

    private static void tinted(PointShade shade, PixelBatch batch, int i) {
        shade.tinted(
                batch.fromBehind[i],
                batch.values(RED)[i],
                batch.values(GREEN)[i],
                batch.values(BLUE)[i]);
    }
}
