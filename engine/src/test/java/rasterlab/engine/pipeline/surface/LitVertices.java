package rasterlab.engine.pipeline.surface;

import rasterlab.engine.light.PointLighting;
import rasterlab.engine.pipeline.fast.VertexBlock;
import rasterlab.engine.pipeline.fast.VertexColors;

/** The light of a whole scene on vertices, found while the pipeline draws. */
final class LitVertices implements VertexColors {
    private final ThreadLocal<PointShade> shades;

    LitVertices(PointLighting lighting) {
        PointLighting now = lighting.forThread();
        shades = ThreadLocal.withInitial(() -> new PointShade(now));
    }

    @Override
    public void color(VertexBlock block) {
        PointShade shade = shades.get();
        for (int i = 0; i < block.count; i++) {
            shade.place(block.x[i], block.y[i], block.z[i], block.nx[i], block.ny[i], block.nz[i]);
            shade.byMaterial(false);
            block.red[i] = shade.rgba[0];
            block.green[i] = shade.rgba[1];
            block.blue[i] = shade.rgba[2];
            block.alpha[i] = shade.rgba[3];
        }
    }
}
