package rasterlab.engine.light.face;

import rasterlab.contract.LitFace;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.normals.TriangleNormal;

/**
 * The normal of a face after the perspective division, which the division has turned.
 *
 * <p>The eye looks at the face's middle; coordinates across the line of sight are divided by the
 * depth along it (times the middle's depth, so that sizes stay), the depth is kept.
 */
final class DividedNormal {
    private DividedNormal() {}

    static void of(LitFace face, double[] middle, double[] normal) {
        double[] forward = FacePoint.difference(middle, face.eye());
        double depth = UnitVector.length(forward);
        UnitVector.normalize(forward);
        double[] right = across(forward);
        double[] up = {
            forward[1] * right[2] - forward[2] * right[1],
            forward[2] * right[0] - forward[0] * right[2],
            forward[0] * right[1] - forward[1] * right[0]
        };
        var divided = new double[9];
        for (int k = 0; k < 9; k += 3) {
            double[] corner = {face.corners()[k], face.corners()[k + 1], face.corners()[k + 2]};
            double[] seen = FacePoint.difference(corner, face.eye());
            double along = dot(seen, forward);
            double shrink = depth / along;
            for (int c = 0; c < 3; c++)
                divided[k + c] =
                        shrink * (dot(seen, right) * right[c] + dot(seen, up) * up[c])
                                + along * forward[c];
        }
        TriangleNormal.cross(divided, new int[] {0, 1, 2}, 0, normal);
    }

    /** A unit vector across another one. */
    private static double[] across(double[] forward) {
        double[] across =
                Math.abs(forward[2]) < 0.9
                        ? new double[] {forward[1], -forward[0], 0}
                        : new double[] {0, forward[2], -forward[1]};
        UnitVector.normalize(across);
        return across;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
