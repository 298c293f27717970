package rasterlab.engine.pipeline.direct;

import rasterlab.engine.pipeline.fast.VertexBlock;
import rasterlab.engine.pipeline.fast.VertexColors;

/** One colour for each face, whose vertices are its own. */
final class FaceTint implements VertexColors {
    private final PackedCorners corners;
    private final int[] faceArgb;

    /**
     * @param faces packed apart
     * @param faceArgb one colour 0xAARRGGBB for each face of the whole mesh
     */
    FaceTint(PackedFaces faces, int[] faceArgb) {
        corners = faces.corners();
        this.faceArgb = faceArgb;
    }

    @Override
    public void color(VertexBlock block) {
        for (int i = 0; i < block.count; i++) {
            int argb = faceArgb[corners.faceOf(block.first + i)];
            block.red[i] = (argb >> 16 & 255) / 255f;
            block.green[i] = (argb >> 8 & 255) / 255f;
            block.blue[i] = (argb & 255) / 255f;
            block.alpha[i] = (argb >>> 24) / 255f;
        }
    }
}
