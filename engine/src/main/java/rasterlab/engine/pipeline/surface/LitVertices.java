package rasterlab.engine.pipeline.surface;

import rasterlab.engine.light.PointLighting;
import rasterlab.engine.pipeline.fast.VertexBlock;
import rasterlab.engine.pipeline.fast.VertexColors;

/**
 * The light of a whole scene on vertices, for flat and Gouraud shading.
 *
 * <p>In a two-sided model a vertex counts as a back where its normal points away from the eye.
 */
public final class LitVertices implements VertexColors {
    private final ThreadLocal<PointShade> shades;
    private final boolean meshColors;

    /**
     * @param lighting its lights and eye in eye space; where it stands now counts
     * @param meshColors whether the mesh's own colours, white where it has none, stand for the
     *     material's ambient and diffuse shares and its alpha
     */
    public LitVertices(PointLighting lighting, boolean meshColors) {
        PointLighting now = lighting.forThread();
        shades = ThreadLocal.withInitial(() -> new PointShade(now));
        this.meshColors = meshColors;
    }

    @Override
    public void color(VertexBlock block) {
        PointShade shade = shades.get();
        for (int i = 0; i < block.count; i++) {
            shade.place(block.x[i], block.y[i], block.z[i], block.nx[i], block.ny[i], block.nz[i]);
            boolean behind = shade.seesBack();
            if (meshColors)
                shade.colored(behind, block.red[i], block.green[i], block.blue[i], block.alpha[i]);
            else shade.byMaterial(behind);
            block.red[i] = shade.rgba[0];
            block.green[i] = shade.rgba[1];
            block.blue[i] = shade.rgba[2];
            block.alpha[i] = shade.rgba[3];
        }
    }
}
