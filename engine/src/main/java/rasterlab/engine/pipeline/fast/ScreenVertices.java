package rasterlab.engine.pipeline.fast;

import java.util.Arrays;

/** Vertices on the picture: what is read together lies together. Grows and never shrinks. */
final class ScreenVertices {
    private static final int GROUP_BITS = 5;

    /** Successive vertices whose attributes are needed together or not at all. */
    static final int GROUP = 1 << GROUP_BITS;

    /** The half of a place that is x. */
    static final long X_MASK = 0xFFFFFFFFL;

    /**
     * The y of each vertex and, in the lower half, x, in steps of 1/256 pixel: see {@link
     * Subpixels}.
     */
    long[] places = new long[0];

    /** See {@link ClipCode}. */
    short[] code = new short[0];

    /**
     * {@link #stride} numbers for each vertex: its depth, 0 at the near plane and 1 at the far
     * plane, and its nearness 1/w, both linear on the picture; then its attributes, what the
     * surface wants, as {@link FrameState#attribute} lists it; colours are levels 0 to 255 for
     * surfaces of vertices, else 0 to 1. Those of a mesh are found for needed vertices only.
     */
    float[] values = new float[0];

    /** How many numbers a vertex has. */
    int stride;

    /** Whether a triangle in sight has a vertex of the group, for each group. */
    boolean[] needed = new boolean[0];

    void need(int a, int b, int c) {
        need(a);
        need(b);
        need(c);
    }

    /**
     * Notes that a vertex is needed, writing once: threads whose groups share a cache line would
     * take it from each other.
     */
    private void need(int vertex) {
        if (!needed[vertex >> GROUP_BITS]) needed[vertex >> GROUP_BITS] = true;
    }

    int x(int vertex) {
        return (int) places[vertex];
    }

    int y(int vertex) {
        return (int) (places[vertex] >> 32);
    }

    float depth(int vertex) {
        return values[stride * vertex];
    }

    float nearness(int vertex) {
        return values[stride * vertex + 1];
    }

    /** Where a vertex's attributes begin. */
    int at(int vertex) {
        return stride * vertex + 2;
    }

    float attribute(int k, int vertex) {
        return values[at(vertex) + k];
    }

    void putAttribute(int k, int vertex, float value) {
        values[at(vertex) + k] = value;
    }

    static long place(int x, int y) {
        return (long) y << 32 | x & X_MASK;
    }

    void put(int vertex, float depth, float nearness) {
        values[stride * vertex] = depth;
        values[stride * vertex + 1] = nearness;
    }

    void put(int vertex, int x, int y, float depth, float nearness) {
        places[vertex] = place(x, y);
        put(vertex, depth, nearness);
    }

    /** Forgets all vertices and makes room for others. */
    void begin(int vertices, int attributeCount) {
        stride = 2 + attributeCount;
        ensure(vertices);
    }

    /** Makes room; what was there stays, but what vertices are needed. */
    void ensure(int vertices) {
        int room = code.length;
        if (room < vertices) room = Math.max(vertices, room + (room >> 1));
        if (values.length < vertices * stride) values = Arrays.copyOf(values, room * stride);
        if (room == code.length) return;
        places = Arrays.copyOf(places, room);
        code = Arrays.copyOf(code, room);
        needed = new boolean[room / GROUP + 1];
    }
}
