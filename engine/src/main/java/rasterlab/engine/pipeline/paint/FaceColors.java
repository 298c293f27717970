package rasterlab.engine.pipeline.paint;

import java.util.Arrays;

/**
 * One colour 0xAARRGGBB for each face.
 *
 * @param argb by face
 */
record FaceColors(int[] argb) implements SurfaceColor {
    @Override
    public void light(int face, PixelRow row) {
        Arrays.fill(row.argb, 0, row.size, argb[face]);
    }
}
