package rasterlab.engine.scene;

/** The quantities that a {@link TriangleMesh} can have for a vertex, one number each. */
public enum VertexQuantity {
    /** World units. */
    X,
    Y,
    Z,
    /** Coordinates of the outward normal of length 1. */
    NORMAL_X,
    NORMAL_Y,
    NORMAL_Z,
    /** 0 to 1 is the texture from left to right. */
    TEXTURE_S,
    /** 0 to 1 is the texture from bottom to top. */
    TEXTURE_T,
    /** 0 to 1. */
    RED,
    GREEN,
    BLUE,
    /** 0 is transparent, 1 opaque. */
    ALPHA
}
