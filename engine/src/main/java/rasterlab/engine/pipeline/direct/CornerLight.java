package rasterlab.engine.pipeline.direct;

import java.util.Arrays;
import rasterlab.engine.light.BlockLighting;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.pipeline.fast.VertexBlock;
import rasterlab.engine.pipeline.fast.VertexColors;

/**
 * Gouraud's way: the whole formula at each vertex in sight, in doubles, on the pipeline's threads.
 */
final class CornerLight implements VertexColors {
    private final PackedCorners corners;
    private final boolean tinted;
    private final boolean[] behind;
    private final ThreadLocal<Lit> lit;

    /** The working memory of a thread. */
    private record Lit(PointLighting points, BlockLighting blocks, float[] rgba) {}

    /**
     * @param behind whether each face shows its back, where that counts; then faces are packed
     *     apart
     */
    CornerLight(PackedFaces faces, PointLighting lighting, boolean[] behind) {
        corners = faces.corners();
        tinted = faces.mesh().hasColors();
        this.behind = behind;
        lit =
                ThreadLocal.withInitial(
                        () -> new Lit(lighting.forThread(), lighting.forBlocks(), new float[4]));
    }

    @Override
    public void color(VertexBlock block) {
        Lit own = lit.get();
        if (tinted || behind.length > 0) {
            lightEach(own, block);
            return;
        }
        BlockLighting fronts = own.blocks;
        for (int from = 0; from < block.count; from += BlockLighting.SIZE) {
            int count = Math.min(BlockLighting.SIZE, block.count - from);
            int first = block.first + from;
            System.arraycopy(corners.x, first, fronts.x, 0, count);
            System.arraycopy(corners.y, first, fronts.y, 0, count);
            System.arraycopy(corners.z, first, fronts.z, 0, count);
            System.arraycopy(corners.nx, first, fronts.nx, 0, count);
            System.arraycopy(corners.ny, first, fronts.ny, 0, count);
            System.arraycopy(corners.nz, first, fronts.nz, 0, count);
            fronts.light(count);
            System.arraycopy(fronts.red, 0, block.red, from, count);
            System.arraycopy(fronts.green, 0, block.green, from, count);
            System.arraycopy(fronts.blue, 0, block.blue, from, count);
        }
        Arrays.fill(block.alpha, 0, block.count, fronts.alpha());
    }

    private void lightEach(Lit own, VertexBlock block) {
        float[] rgba = own.rgba;
        for (int i = 0; i < block.count; i++) {
            rgba[0] = block.red[i];
            rgba[1] = block.green[i];
            rgba[2] = block.blue[i];
            light(own.points, block.first + i, rgba);
            block.red[i] = rgba[0];
            block.green[i] = rgba[1];
            block.blue[i] = rgba[2];
            block.alpha[i] = rgba[3];
        }
    }

    private void light(PointLighting lighting, int v, float[] rgba) {
        double x = corners.x[v];
        double y = corners.y[v];
        double z = corners.z[v];
        double nx = corners.nx[v];
        double ny = corners.ny[v];
        double nz = corners.nz[v];
        boolean back = behind.length > 0 && behind[corners.faceOf(v)];
        if (tinted) lighting.shadeTinted(x, y, z, nx, ny, nz, back, rgba, 0);
        else lighting.shade(x, y, z, nx, ny, nz, back, rgba, 0);
    }
}
