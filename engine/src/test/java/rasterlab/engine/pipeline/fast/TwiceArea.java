package rasterlab.engine.pipeline.fast;

/**
 * Computes twice the area of the triangle of vertices 0, 1 and 2, in squared steps; negative where
 * it turns counter-clockwise on the picture.
 */
final class TwiceArea {
    private TwiceArea() {}

    static long of(ScreenVertices v) {
        return of(v, 0);
    }

    /**
     * @param a the first of its three vertices
     */
    static long of(ScreenVertices v, int a) {
        return (long) (v.x(a + 1) - v.x(a)) * (v.y(a + 2) - v.y(a))
                - (long) (v.x(a + 2) - v.x(a)) * (v.y(a + 1) - v.y(a));
    }
}
