package rasterlab.engine.polygon.triangulation;

/**
 * A polygon on its way into triangles, one per step.
 *
 * <p>A new walk stands before its first triangle. Drain it with {@code while (walk.advance())
 * take(walk.a(), walk.b(), walk.c());}. Before the first {@link #advance} and after it returned
 * false, the corners mean nothing.
 */
public interface TriangleWalk {
    /** Cuts the next triangle off; false when there is none, and then again each time. */
    boolean advance();

    /** Number of the triangle's first corner. */
    int a();

    /** Number of the corner that is cut off. */
    int b();

    /** Number of the triangle's last corner; a–c is the diagonal. */
    int c();

    /** Turns of three corners computed so far, those before the first triangle included. */
    long turns();
}
