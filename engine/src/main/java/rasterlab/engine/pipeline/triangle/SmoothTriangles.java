package rasterlab.engine.pipeline.triangle;

/** Draws triangles with the colours of their vertices, perspective-correct between them. */
interface SmoothTriangles {
    /**
     * Draws what a triangle has in one band of rows.
     *
     * @param bandTop first row of the band
     */
    void draw(
            ScreenVertices vertices,
            int first,
            int second,
            int third,
            DepthRaster out,
            int bandTop);
}
