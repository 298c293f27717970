package rasterlab.engine.pipeline.surface;

/** How a pixel gets its colour from the texels. */
public enum TexelFilter {
    /** The texel that the pixel's centre lies in. */
    NEAREST,
    /** The four texels around the centre, of the picture itself. */
    LINEAR,
    /** The linear filter in the two levels of detail that fit the pixel best. */
    MIPMAP,
    /** Texture coordinates linear on the screen: right only where the triangle faces the eye. */
    AFFINE_NEAREST
}
