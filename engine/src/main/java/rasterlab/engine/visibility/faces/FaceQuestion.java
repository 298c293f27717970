package rasterlab.engine.visibility.faces;

import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;

/**
 * Whether the first face of a tetrahedron, in the plane y = x, is seen by an eye near that plane.
 */
final class FaceQuestion implements PointQuestion<Body, SeenFaces> {
    private static final double[] CORNERS = {-24, -24, 0, 12, 12, 0, 12, 12, 24, 12, -24, 0};
    private static final int[][] FACES = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    private static final double EYE_Z = 3.3;

    @Override
    public int size() {
        return 64;
    }

    @Override
    public double left(Spacing spacing) {
        return HALF;
    }

    @Override
    public double low(Spacing spacing) {
        return HALF;
    }

    @Override
    public Body input(Spacing spacing, double x, double y) {
        return Body.seenFrom(new double[] {x, y, EYE_Z}, CORNERS, FACES);
    }

    @Override
    public boolean yes(SeenFaces output) {
        return output.visible(0);
    }
}
