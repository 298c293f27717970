package rasterlab.engine.pipeline.paint;

import java.util.Optional;
import rasterlab.engine.raster.Blend;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FacePaint;

/** Light, then texture, then depth cue, then what is behind: I = I₁·α + I₂·(1 − α). */
final class LayeredPaint implements FacePaint {
    private final CornerWeights weights;
    private final SurfaceColor light;
    private final TextureLayer texture;
    private final Optional<DepthFade> fade;
    private final boolean[] opaque;
    private final int[] outlines;
    private final ThreadLocal<PixelRow> rows;

    /**
     * @param opaque by face
     * @param outlines colours 0xAARRGGBB by face; an empty array where no outline is drawn
     * @param width of the picture in pixels
     */
    LayeredPaint(
            CornerWeights weights,
            SurfaceColor light,
            TextureLayer texture,
            Optional<DepthFade> fade,
            boolean[] opaque,
            int[] outlines,
            int width) {
        this.weights = weights;
        this.light = light;
        this.texture = texture;
        this.fade = fade;
        this.opaque = opaque;
        this.outlines = outlines;
        rows = ThreadLocal.withInitial(() -> new PixelRow(width));
    }

    @Override
    public void span(int face, int y, int from, int to, Raster out) {
        PixelRow row = rows.get();
        weights.load(face, y, from, to, row);
        light.light(face, row);
        texture.lay(face, row);
        if (fade.isPresent()) fade(fade.get(), row);
        int at = y * out.width() + from;
        if (opaque[face]) System.arraycopy(row.argb, 0, out.argb(), at, row.size);
        else layOver(row, out.argb(), at);
    }

    private static void fade(DepthFade fade, PixelRow row) {
        for (int i = 0; i < row.size; i++) row.argb[i] = fade.over(row.argb[i], row.depth[i]);
    }

    private static void layOver(PixelRow row, int[] behind, int at) {
        for (int i = 0; i < row.size; i++) behind[at + i] = Blend.over(row.argb[i], behind[at + i]);
    }

    @Override
    public boolean opaque(int face) {
        return opaque[face];
    }

    @Override
    public boolean hasOutline() {
        return outlines.length != 0;
    }

    @Override
    public int outline(int face) {
        return outlines[face];
    }
}
