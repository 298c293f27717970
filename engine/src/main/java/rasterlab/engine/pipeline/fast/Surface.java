package rasterlab.engine.pipeline.fast;

/** How the pixels of a triangle get their colours. */
public sealed interface Surface {
    /** Colours of vertices are all that is needed; such a surface is opaque. */
    sealed interface OfVertices extends Surface {
        VertexColors colors();
    }

    /** Every pixel of a triangle has the colour of the triangle's third vertex, as in OpenGL. */
    record Flat(VertexColors colors) implements OfVertices {}

    /** Gouraud's way: colours of the vertices, perspective-correct between them. */
    record Smooth(VertexColors colors) implements OfVertices {}

    /**
     * A colour for each pixel from what lies between the vertices: Phong's way, textures,
     * transparency.
     *
     * @param under where red, green, blue and alpha come from, if the pixels want them
     */
    record PerPixel(PixelColors colors, OfVertices under, Blending blending) implements Surface {
        /** A surface that is opaque, over the mesh's own colours. */
        public PerPixel(PixelColors colors) {
            this(colors, new Smooth(VertexColors.own()), Blending.OPAQUE);
        }

        /** This surface over the colours of another surface. */
        public PerPixel over(OfVertices other) {
            return new PerPixel(colors, other, blending);
        }

        public PerPixel with(Blending other) {
            return new PerPixel(colors, under, other);
        }
    }
}
