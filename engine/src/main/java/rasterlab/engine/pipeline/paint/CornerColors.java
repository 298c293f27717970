package rasterlab.engine.pipeline.paint;

import rasterlab.engine.color.Levels;
import rasterlab.engine.scene.Mesh;

/**
 * Gouraud's shading: the whole formula at the corners, mixed between them with perspective.
 *
 * <p>Each channel is cut to [0, 1] at the corners, before it is mixed, as OpenGL does it; so a
 * highlight inside a face is lost and one at a corner is spread over the face.
 *
 * <p>Source: H. Gouraud, Continuous shading of curved surfaces, IEEE Transactions on Computers
 * 20(6), 1971, pp. 623–629.
 */
final class CornerColors implements SurfaceColor {
    private final Mesh mesh;

    /** Red, green, blue and alpha, 0 to 1, of each corner. */
    private final float[] rgba;

    /**
     * @param faces the light on them
     */
    CornerColors(FaceLights faces) {
        mesh = faces.mesh();
        rgba = faces.atCorners();
    }

    @Override
    public void light(int face, PixelRow row) {
        int a = 4 * mesh.firstCorner(face);
        for (int i = 0; i < row.size; i++) {
            int b = a + 4 * row.fan[i];
            int c = b + 4;
            double w0 = row.weight0[i];
            double w1 = row.weight1[i];
            double w2 = row.weight2[i];
            row.argb[i] =
                    Levels.argb(
                            w0 * rgba[a] + w1 * rgba[b] + w2 * rgba[c],
                            w0 * rgba[a + 1] + w1 * rgba[b + 1] + w2 * rgba[c + 1],
                            w0 * rgba[a + 2] + w1 * rgba[b + 2] + w2 * rgba[c + 2],
                            w0 * rgba[a + 3] + w1 * rgba[b + 3] + w2 * rgba[c + 3]);
        }
    }
}
