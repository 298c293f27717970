package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;

/** Vertices on the picture, one array for each quantity; grows and never shrinks. */
final class ScreenVertices {
    /** Successive vertices whose attributes are needed together or not at all. */
    static final int GROUP = 32;

    /** Steps of 1/256 pixel; see {@link Subpixels}. */
    int[] x = new int[0];

    int[] y = new int[0];

    /** 0 at the near plane, 1 at the far plane; linear on the picture. */
    float[] depth = new float[0];

    /** 1/w; linear on the picture. */
    float[] nearness = new float[0];

    /** See {@link ClipCode}. */
    short[] code = new short[0];

    /**
     * What the surface wants of a vertex, as {@link Frame#attribute} lists it; colours are levels 0
     * to 255 for surfaces of vertices, else 0 to 1.
     */
    float[][] attributes = new float[0][];

    /** For each group, whether a triangle in sight has one of its vertices. */
    boolean[] needed = new boolean[0];

    void need(int a, int b, int c) {
        needed[a / GROUP] = true;
        needed[b / GROUP] = true;
        needed[c / GROUP] = true;
    }

    /** Makes room; what was there stays. */
    void ensure(int vertices, int attributeCount) {
        if (attributes.length < attributeCount) {
            int had = attributes.length;
            attributes = Arrays.copyOf(attributes, attributeCount);
            for (int k = had; k < attributeCount; k++) attributes[k] = new float[x.length];
        }
        if (x.length >= vertices) return;
        int room = Math.max(vertices, x.length + (x.length >> 1));
        x = Arrays.copyOf(x, room);
        y = Arrays.copyOf(y, room);
        depth = Arrays.copyOf(depth, room);
        nearness = Arrays.copyOf(nearness, room);
        code = Arrays.copyOf(code, room);
        needed = new boolean[room / GROUP + 1];
        for (int k = 0; k < attributes.length; k++)
            attributes[k] = Arrays.copyOf(attributes[k], room);
    }
}
