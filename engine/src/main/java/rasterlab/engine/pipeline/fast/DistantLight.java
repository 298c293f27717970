package rasterlab.engine.pipeline.fast;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.scene.VertexQuantity;

/**
 * One light from very far away on one material, for vertices and for pixels, by the same loops.
 *
 * <p>{@code I = base·(ambient + (1 − ambient)·max(0, n·l)) + specular·max(0, n·h)^shininess}, n
 * brought to length 1, l to the light, {@code h} halfway between l and the direction to the eye; a
 * face turned from the light has no highlight. Sums above 1 are cut. The power is made of squares.
 *
 * <p>Source: J. F. Blinn, Models of light reflection for computer synthesized pictures, SIGGRAPH
 * 1977.
 */
public final class DistantLight implements VertexColors, PixelColors {
    /** The largest shininess, as in OpenGL's successors and the course. */
    public static final int SHINIEST = 200;

    private static final Set<VertexQuantity> WANTS =
            EnumSet.range(VertexQuantity.X, VertexQuantity.NORMAL_Z);

    private final LightLoops one = LightLoops.of(Lanes.ONE);
    private final LightLoops best = LightLoops.of(Lanes.best());

    /** Direction to the light, of length 1. */
    private final float[] light = new float[3];

    private final float[] base = new float[3];
    private final float ambient;
    private final float specular;
    private final int shininess;

    /**
     * @param toLight direction to the light in eye space, of any length above 0
     * @param baseRgb the material's colour 0xRRGGBB
     * @param ambient 0 to 1
     * @param specular of the white highlight, 0 to 1
     * @param shininess 1 to {@value #SHINIEST}
     */
    public DistantLight(
            double[] toLight, int baseRgb, double ambient, double specular, int shininess) {
        double length = Math.sqrt(square(toLight[0]) + square(toLight[1]) + square(toLight[2]));
        if (!(length > 0 && length < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "direction to the light must be finite and not zero, got (%s, %s, %s)"
                            .formatted(toLight[0], toLight[1], toLight[2]));
        requireShare("ambient", ambient);
        requireShare("specular", specular);
        if (shininess < 1 || shininess > SHINIEST)
            throw new IllegalArgumentException(
                    "shininess must be from 1 to %d, got %d".formatted(SHINIEST, shininess));
        for (int k = 0; k < 3; k++) light[k] = (float) (toLight[k] / length);
        for (int c = 0; c < 3; c++) base[c] = (baseRgb >> 16 - 8 * c & 255) / 255f;
        this.ambient = (float) ambient;
        this.specular = (float) specular;
        this.shininess = shininess;
    }

    private static double square(double v) {
        return v * v;
    }

    private static void requireShare(String name, double share) {
        if (!(share >= 0 && share <= 1))
            throw new IllegalArgumentException(name + " must be from 0 to 1, got " + share);
    }

    @Override
    public Set<VertexQuantity> wants() {
        return WANTS;
    }

    @Override
    public Set<VertexQuantity> directions() {
        return WANTS;
    }

    private LightLoops loops(Lanes lanes) {
        return lanes == Lanes.ONE ? one : best;
    }

    @Override
    public void color(VertexBlock block) {
        int n = block.count;
        float[] diffuse = block.nx;
        float[] highlight = block.nz;
        LightLoops loops = loops(block.lanes());
        loops.cosines(
                n,
                light,
                block.x,
                block.y,
                block.z,
                diffuse,
                block.ny,
                highlight,
                block.red,
                block.green);
        power(n, block.ny, highlight);
        channel(loops, n, 0, diffuse, highlight, block.red);
        channel(loops, n, 1, diffuse, highlight, block.green);
        channel(loops, n, 2, diffuse, highlight, block.blue);
    }

    @Override
    public void color(PixelBatch batch) {
        float[] x = batch.values(VertexQuantity.X);
        float[] y = batch.values(VertexQuantity.Y);
        float[] z = batch.values(VertexQuantity.Z);
        float[] diffuse = batch.values(VertexQuantity.NORMAL_X);
        float[] halfway = batch.values(VertexQuantity.NORMAL_Y);
        float[] highlight = batch.values(VertexQuantity.NORMAL_Z);
        int n = batch.count;
        LightLoops loops = loops(batch.lanes());
        loops.cosines(n, light, x, y, z, diffuse, halfway, highlight, batch.weightB, batch.weightC);
        power(n, halfway, highlight);
        channel(loops, n, 0, diffuse, highlight, x);
        channel(loops, n, 1, diffuse, highlight, y);
        channel(loops, n, 2, diffuse, highlight, z);
        batch.pack(x, y, z);
    }

    /** result = specular times a cosine to the power of the shininess; its squares are lost. */
    private void power(int n, float[] squaredCosine, float[] result) {
        if (shininess % 2 == 0) Arrays.fill(result, 0, n, specular);
        else for (int i = 0; i < n; i++) result[i] = specular * (float) Math.sqrt(squaredCosine[i]);
        for (int left = shininess / 2; left > 0; left >>= 1) {
            if ((left & 1) != 0) for (int i = 0; i < n; i++) result[i] *= squaredCosine[i];
            if (left > 1) for (int i = 0; i < n; i++) squaredCosine[i] *= squaredCosine[i];
        }
    }

    private void channel(
            LightLoops loops, int n, int c, float[] diffuse, float[] highlight, float[] out) {
        float share = base[c];
        loops.channel(n, share * ambient, share * (1 - ambient), diffuse, highlight, out);
    }
}
