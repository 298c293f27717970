package rasterlab.engine.pipeline.surface;

import static rasterlab.engine.scene.VertexQuantity.ALPHA;
import static rasterlab.engine.scene.VertexQuantity.BLUE;
import static rasterlab.engine.scene.VertexQuantity.GREEN;
import static rasterlab.engine.scene.VertexQuantity.RED;

import java.util.EnumSet;
import java.util.Set;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
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
        batch.pack(batch.values(RED), batch.values(GREEN), batch.values(BLUE), batch.values(ALPHA));
    }
}
