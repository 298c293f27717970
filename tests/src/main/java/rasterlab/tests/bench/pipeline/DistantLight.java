package rasterlab.tests.bench.pipeline;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.pipeline.fast.VertexBlock;
import rasterlab.engine.pipeline.fast.VertexColors;
import rasterlab.engine.scene.VertexQuantity;

/**
 * One light from very far away on one material, for vertices and for pixels, by the same loops:
 * what {@link GlProgram} has as a shader.
 *
 * <p>{@code I = base·(ambient + (1 − ambient)·max(0, n·l)) + specular·max(0, n·h)^shininess}, n
 * brought to length 1, l to the light, {@code h} halfway between l and the direction to the eye; a
 * face turned from the light has no highlight. Sums above 1 are cut. The power is made of squares.
 *
 * <p>Source: J. F. Blinn, Models of light reflection for computer synthesized pictures, SIGGRAPH
 * 1977.
 */
final class DistantLight implements VertexColors, PixelColors {
    /** The largest shininess, as in OpenGL's successors and the course. */
    static final int SHINIEST = 200;

    private static final Set<VertexQuantity> WANTS =
            EnumSet.range(VertexQuantity.X, VertexQuantity.NORMAL_Z);

    /** Far above 1 over any cosine that a float can tell from 0 in a picture. */
    private static final float LIT = 1e6f;

    /** 2, and so much more that rounding leaves nothing below 0. */
    private static final float ROOM = 2 + 0x1p-19f;

    /** Room for the numbers of a batch's pixels, for each thread. */
    private final ThreadLocal<float[][]> room =
            ThreadLocal.withInitial(() -> new float[2][PixelBatch.SIZE]);

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
    DistantLight(double[] toLight, int baseRgb, double ambient, double specular, int shininess) {
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

    @Override
    public void color(VertexBlock block) {
        int n = block.count;
        float[] diffuse = block.nx;
        float[] highlight = block.nz;
        cosines(
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
        channel(n, 0, diffuse, highlight, block.red);
        channel(n, 1, diffuse, highlight, block.green);
        channel(n, 2, diffuse, highlight, block.blue);
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
        cosines(n, light, x, y, z, diffuse, halfway, highlight, room.get()[0], room.get()[1]);
        power(n, halfway, highlight);
        channel(n, 0, diffuse, highlight, x);
        channel(n, 1, diffuse, highlight, y);
        channel(n, 2, diffuse, highlight, z);
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

    /** Computes a channel: min(1, base·(ambient + (1 − ambient)·diffuse) + highlight). */
    private void channel(int n, int c, float[] diffuse, float[] highlight, float[] out) {
        float steady = base[c] * ambient;
        float lit = base[c] * (1 - ambient);
        for (int i = 0; i < n; i++) out[i] = Math.min(1, steady + lit * diffuse[i] + highlight[i]);
    }

    /**
     * Replaces nx by max(0, n·l) and ny by max(0, n·h)², or 0 where n·l is 0; all else is lost. The
     * loops are so short that the compiler makes vectors of them.
     *
     * <p>With p the place, {@code h = l − p/|p|}, so {@code |h|²·p² = 2p² − 2(p·l)|p|} and {@code
     * n·h·|p| = (n·l)|p| − n·p}: neither h nor its length is needed, and one division does for both
     * cosines.
     *
     * @param light l
     * @param far room for n numbers, as {@code along}
     */
    private static void cosines(
            int n,
            float[] light,
            float[] x,
            float[] y,
            float[] z,
            float[] nx,
            float[] ny,
            float[] nz,
            float[] far,
            float[] along) {
        float lx = light[0];
        float ly = light[1];
        float lz = light[2];
        lengths(n, x, y, z, far);
        for (int i = 0; i < n; i++) along[i] = nx[i] * x[i] + ny[i] * y[i] + nz[i] * z[i];
        for (int i = 0; i < n; i++) {
            float twice = 2 * (lx * x[i] + ly * y[i] + lz * z[i]);
            x[i] = far[i] * (ROOM * far[i] - twice);
        }
        for (int i = 0; i < n; i++) z[i] = nx[i] * lx + ny[i] * ly + nz[i] * lz;
        lengths(n, nx, ny, nz, y);
        for (int i = 0; i < n; i++) along[i] = aboveZero(z[i] * far[i] - along[i]);
        for (int i = 0; i < n; i++) far[i] = 1 / (x[i] * y[i]);
        for (int i = 0; i < n; i++) nx[i] = aboveZero(z[i] * (x[i] * far[i]));
        // 0 where no light falls, else 1 but for a sliver of angles: a step without a branch.
        for (int i = 0; i < n; i++) {
            float part = along[i] * far[i];
            ny[i] = part * part * x[i] * Math.min(1, nx[i] * LIT);
        }
    }

    private static void lengths(int n, float[] x, float[] y, float[] z, float[] out) {
        for (int i = 0; i < n; i++)
            out[i] = (float) Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    }

    /** max(0, v), exactly: Java's own, which heeds the sign of 0, is slower in vectors. */
    private static float aboveZero(float v) {
        return 0.5f * (v + Math.abs(v));
    }
}
