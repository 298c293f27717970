package rasterlab.engine.pipeline.triangle;

/** How the pixels of a triangle get their colours. */
public sealed interface Surface {
    /** Every pixel of a triangle has the colour of the triangle's third vertex, as in OpenGL. */
    record Flat(VertexColors colors) implements Surface {}

    /** Gouraud's way: colours of the vertices, perspective-correct between them. */
    record Smooth(VertexColors colors) implements Surface {}

    /** A colour for each pixel from what lies between the vertices: Phong's way, textures. */
    record PerPixel(PixelColors colors) implements Surface {}
}
