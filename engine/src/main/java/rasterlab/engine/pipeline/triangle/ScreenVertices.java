package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;

/** Vertices on the picture: what is read together lies together. Grows and never shrinks. */
final class ScreenVertices {
    /** Successive vertices whose attributes are needed together or not at all. */
    static final int GROUP = 32;

    /** Of each vertex x and y, in steps of 1/256 pixel; see {@link Subpixels}. */
    private int[] places = new int[0];

    /**
     * Of each vertex its depth, 0 at the near plane and 1 at the far plane, and its nearness 1/w;
     * both are linear on the picture.
     */
    private float[] depthsAndNearness = new float[0];

    /** See {@link ClipCode}. */
    short[] code = new short[0];

    /**
     * Of each vertex, {@link #stride} numbers: what the surface wants, as {@link Frame#attribute}
     * lists it; colours are levels 0 to 255 for surfaces of vertices, else 0 to 1.
     */
    float[] attributes = new float[0];

    /** How many attributes a vertex has. */
    int stride;

    /** For each group, whether a triangle in sight has one of its vertices. */
    boolean[] needed = new boolean[0];

    void need(int a, int b, int c) {
        needed[a / GROUP] = true;
        needed[b / GROUP] = true;
        needed[c / GROUP] = true;
    }

    int x(int vertex) {
        return places[2 * vertex];
    }

    int y(int vertex) {
        return places[2 * vertex + 1];
    }

    float depth(int vertex) {
        return depthsAndNearness[2 * vertex];
    }

    float nearness(int vertex) {
        return depthsAndNearness[2 * vertex + 1];
    }

    /** Where a vertex's attributes begin. */
    int at(int vertex) {
        return stride * vertex;
    }

    float attribute(int k, int vertex) {
        return attributes[at(vertex) + k];
    }

    void putAttribute(int k, int vertex, float value) {
        attributes[at(vertex) + k] = value;
    }

    void put(int vertex, int x, int y, float depth, float nearness) {
        places[2 * vertex] = x;
        places[2 * vertex + 1] = y;
        depthsAndNearness[2 * vertex] = depth;
        depthsAndNearness[2 * vertex + 1] = nearness;
    }

    /** Forgets all vertices and makes room for others. */
    void begin(int vertices, int attributeCount) {
        stride = attributeCount;
        ensure(vertices);
    }

    /** Makes room; what was there stays, but what vertices are needed. */
    void ensure(int vertices) {
        int room = code.length;
        if (room < vertices) room = Math.max(vertices, room + (room >> 1));
        if (attributes.length < vertices * stride)
            attributes = Arrays.copyOf(attributes, room * stride);
        if (room == code.length) return;
        places = Arrays.copyOf(places, 2 * room);
        depthsAndNearness = Arrays.copyOf(depthsAndNearness, 2 * room);
        code = Arrays.copyOf(code, room);
        needed = new boolean[room / GROUP + 1];
    }
}
