package rasterlab.engine.pipeline.fast;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import rasterlab.engine.scene.VertexQuantity;

/**
 * Pixels that wait for their colours; cells [0, count) are used. Who gets a batch may overwrite its
 * values.
 */
public final class PixelBatch {
    /**
     * The most pixels of a batch: as many as the largest {@linkplain RowDepth compact} box has.
     * Batches of half as many are slower by a twentieth where triangles have some fifty pixels.
     */
    public static final int SIZE = RowDepth.WIDEST * TriangleScan.ROWS;

    private final Map<VertexQuantity, float[]> values = new EnumMap<>(VertexQuantity.class);
    private final Map<VertexQuantity, float[]> right = new EnumMap<>(VertexQuantity.class);
    private final Map<VertexQuantity, float[]> down = new EnumMap<>(VertexQuantity.class);
    private final Set<VertexQuantity> wanted = EnumSet.noneOf(VertexQuantity.class);
    private final Set<VertexQuantity> sloping = EnumSet.noneOf(VertexQuantity.class);

    /** The cell of the picture. */
    final int[] cell = new int[SIZE];

    /** The weights of the triangle's corners b and c. */
    final float[] weightB = new float[SIZE];

    final float[] weightC = new float[SIZE];

    /** Depth, 0 to 1. */
    final float[] depth = new float[SIZE];

    /** 1/w, linear on the picture; w while colours are found. */
    final float[] nearness = new float[SIZE];

    final PixelSlopes slopes = new PixelSlopes();

    private final float[] squaredSteps = new float[SIZE];

    /** Whether alpha counts for nothing. */
    boolean opaque;

    /** Pixels in use. */
    public int count;

    /** Whether the pixel's triangle turns its inner side to the eye. */
    public final boolean[] fromBehind = new boolean[SIZE];

    /** The colours that come out, 0xAARRGGBB. */
    public final int[] argb = new int[SIZE];

    /** Forgets what waits and makes room for what those colours want. */
    void begin(PixelColors colors) {
        count = 0;
        prepare(wanted, colors.wants(), values);
        prepare(sloping, colors.wantsSlopes(), right);
        prepare(sloping, colors.wantsSlopes(), down);
    }

    private static void prepare(
            Set<VertexQuantity> now, Set<VertexQuantity> next, Map<VertexQuantity, float[]> room) {
        for (VertexQuantity quantity : FrameState.QUANTITIES)
            if (next.contains(quantity)) {
                now.add(quantity);
                if (!room.containsKey(quantity)) room.put(quantity, new float[SIZE]);
            } else now.remove(quantity);
    }

    /** One number for each pixel, perspective-correct: not a copy. */
    public float[] values(VertexQuantity quantity) {
        if (!wanted.contains(quantity))
            throw new IllegalArgumentException(quantity + " was not asked for by wants()");
        return values.get(quantity);
    }

    /**
     * Finds how fast the value, as it is now, grows to the right at the pixels' centres, per pixel;
     * the numbers may be overwritten.
     */
    public float[] right(VertexQuantity quantity) {
        requireSlope(quantity);
        slopes.findRight(quantity, values(quantity), nearness, right.get(quantity));
        return right.get(quantity);
    }

    /** How fast it grows downward. */
    public float[] down(VertexQuantity quantity) {
        requireSlope(quantity);
        slopes.findDown(quantity, values(quantity), nearness, down.get(quantity));
        return down.get(quantity);
    }

    /**
     * Finds ρ² of the texture coordinates as they are now, see {@link
     * rasterlab.engine.texture.DetailLevel}; they must not be affine.
     *
     * @param width of the texture in texels
     * @param height of the texture in texels
     */
    public float[] squaredSteps(int width, int height) {
        requireSlope(VertexQuantity.TEXTURE_S);
        requireSlope(VertexQuantity.TEXTURE_T);
        RowLoops.squareSteps(this, width, height, squaredSteps);
        return squaredSteps;
    }

    private void requireSlope(VertexQuantity quantity) {
        if (!sloping.contains(quantity))
            throw new IllegalArgumentException(
                    "the slope of " + quantity + " was not asked for by wantsSlopes()");
    }

    /**
     * Packs shares of colour, 0 to 1, into the pixels, each to its nearest level.
     *
     * @param red 0 to 1, or beyond by no more than some ulps, as the others; one of the batch's own
     *     arrays, as the others
     * @param alpha counts where the pixels are not opaque
     */
    public void pack(float[] red, float[] green, float[] blue, float[] alpha) {
        PixelLevels.pack(count, red, green, blue, argb);
        if (!opaque) PixelLevels.setAlpha(count, alpha, argb);
    }
}
