package rasterlab.engine.pipeline.triangle;

/**
 * Of the triangle of vertices 0, 1 and 2, in squared steps; negative where it turns
 * counter-clockwise on the picture.
 */
final class TwiceArea {
    private TwiceArea() {}

    static long of(ScreenVertices v) {
        return (long) (v.x(1) - v.x(0)) * (v.y(2) - v.y(0))
                - (long) (v.x(2) - v.x(0)) * (v.y(1) - v.y(0));
    }
}
