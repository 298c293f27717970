package rasterlab.engine.pipeline.surface;

import static rasterlab.engine.scene.VertexQuantity.ALPHA;
import static rasterlab.engine.scene.VertexQuantity.BLUE;
import static rasterlab.engine.scene.VertexQuantity.GREEN;
import static rasterlab.engine.scene.VertexQuantity.RED;

import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.pipeline.triangle.PixelBatch;
import rasterlab.engine.pipeline.triangle.PixelColors;
import rasterlab.engine.scene.VertexQuantity;

/** Pixels have the colours and alpha of the surface under them, to the nearest level. */
public final class ColoredPixels implements PixelColors {
    private static final Set<VertexQuantity> WANTS = EnumSet.range(RED, ALPHA);

    @Override
    public Set<VertexQuantity> wants() {
        return WANTS;
    }

    @Override
    public void color(PixelBatch batch) {
        float[] red = batch.values(RED);
        float[] green = batch.values(GREEN);
        float[] blue = batch.values(BLUE);
        float[] alpha = batch.values(ALPHA);
        for (int i = 0; i < batch.count; i++)
            batch.argb[i] =
                    level(alpha[i]) << 24
                            | level(red[i]) << 16
                            | level(green[i]) << 8
                            | level(blue[i]);
    }

    /** Of a share that rounding may have led beyond 0 to 1 by some ulps. */
    private static int level(float share) {
        return (int) (share * 255 + 0.5f);
    }
}
