package rasterlab.engine.polygon.triangulation;

import java.util.Arrays;
import rasterlab.contract.Triangulator;

/** A method whose steps can be looked at: cutting and stepping drain the same walk. */
public interface SteppedTriangulator extends Triangulator {
    /**
     * A walk over the triangles that {@code triangulate} returns, in the same order.
     *
     * @throws IllegalArgumentException as {@code triangulate} does
     */
    TriangleWalk walk(double[] x, double[] y);

    /** How the next triangle is chosen, in words. */
    String choice();

    @Override
    default int[] triangulate(double[] x, double[] y) {
        TriangleWalk walk = walk(x, y);
        var triples = new int[3 * x.length];
        int size = 0;
        while (walk.advance()) {
            triples[size++] = walk.a();
            triples[size++] = walk.b();
            triples[size++] = walk.c();
        }
        return Arrays.copyOf(triples, size);
    }
}
