package rasterlab.engine.pipeline.fast;

/**
 * A few hundred vertices in eye space, one array for each quantity; cells [0, count) are used. Who
 * gets a block may overwrite all of it.
 */
public final class VertexBlock {
    /** The most vertices of a block: all arrays together stay in the first-level cache. */
    public static final int SIZE = 256;

    /** Vertices in use. */
    public int count;

    /** The mesh's number of the first of them; the others follow it. */
    public int first;

    /** Eye space: x right, y up, −z forward. */
    public final float[] x = new float[SIZE];

    public final float[] y = new float[SIZE];
    public final float[] z = new float[SIZE];

    /**
     * The outward normal in eye space, of length 1 unless the view scales; 0 where there is none.
     */
    public final float[] nx = new float[SIZE];

    public final float[] ny = new float[SIZE];
    public final float[] nz = new float[SIZE];

    /** The mesh's own colour, 0 to 1, or opaque white, which comes in. Out: the vertex's colour. */
    public final float[] red = new float[SIZE];

    public final float[] green = new float[SIZE];
    public final float[] blue = new float[SIZE];

    /** 0 is transparent, 1 opaque. */
    public final float[] alpha = new float[SIZE];
}
