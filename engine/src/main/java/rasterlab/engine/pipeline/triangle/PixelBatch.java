package rasterlab.engine.pipeline.triangle;

import java.util.EnumMap;
import java.util.Map;
import java.util.Set;
import rasterlab.engine.scene.VertexQuantity;

/**
 * Pixels that wait for their colours; cells [0, count) are used. Who gets a batch may overwrite its
 * values.
 */
public final class PixelBatch {
    /** The most pixels of a batch. */
    public static final int SIZE = 512;

    private final Map<VertexQuantity, float[]> values = new EnumMap<>(VertexQuantity.class);

    /** The cell of the picture. */
    final int[] cell = new int[SIZE];

    /** 1/w, linear on the picture. */
    final float[] nearness = new float[SIZE];

    /** Pixels in use. */
    public int count;

    /** Out: the colours, 0xAARRGGBB. */
    public final int[] argb = new int[SIZE];

    PixelBatch(Set<VertexQuantity> wanted) {
        for (VertexQuantity quantity : wanted) values.put(quantity, new float[SIZE]);
    }

    /** One number for each pixel, perspective-correct: not a copy. */
    public float[] values(VertexQuantity quantity) {
        float[] array = values.get(quantity);
        if (array == null)
            throw new IllegalArgumentException(quantity + " was not asked for by wants()");
        return array;
    }
}
