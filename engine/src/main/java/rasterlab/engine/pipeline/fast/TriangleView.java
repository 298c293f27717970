package rasterlab.engine.pipeline.fast;

import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/**
 * How a mesh is looked at: world → eye → clip, planes of the user, and what is culled.
 *
 * <p>Matrices are in the textbook's layout for row points, {@code eye = world · M}, as {@link
 * rasterlab.engine.transform.GlMatrices} makes them; eye → clip decides what is near and far.
 */
public final class TriangleView {
    /** The most planes of the user. */
    public static final int MOST_PLANES = 6;

    private final float[] toEye;
    private final float[] normalToEye;
    private final float[] toClip;
    private final double[][] planes;
    private final Culling culling;

    /**
     * @param worldToEye turns and moves, may scale
     * @param eyeToClip a projection
     * @param eyePlanes up to six planes (a, b, c, d) of eye space; what has ax + by + cz + d &lt; 0
     *     is cut off
     * @throws IllegalArgumentException where a number is not finite or world → eye has no inverse
     */
    public TriangleView(
            Matrix4dc worldToEye, Matrix4dc eyeToClip, List<double[]> eyePlanes, Culling culling) {
        toEye = floats("world to eye", rows(worldToEye));
        toClip = floats("world to clip", rows(new Matrix4d(eyeToClip).mul(worldToEye)));
        normalToEye = floats("the normals' matrix", rows(normalMatrix(worldToEye)));
        planes = worldPlanes(eyePlanes, rows(worldToEye));
        this.culling = culling;
    }

    /** A view without planes of the user; back faces are culled. */
    public TriangleView(Matrix4dc worldToEye, Matrix4dc eyeToClip) {
        this(worldToEye, eyeToClip, List.of(), Culling.BACK);
    }

    /** The inverse's transpose keeps normals upright whatever the scales. */
    private static Matrix4d normalMatrix(Matrix4dc worldToEye) {
        if (!(Math.abs(worldToEye.determinant3x3()) > 0))
            throw new IllegalArgumentException(
                    "world to eye must have an inverse, got determinant "
                            + worldToEye.determinant3x3());
        return worldToEye.normal(new Matrix4d());
    }

    /** JOML keeps column vectors; its columns are the textbook's rows. */
    private static double[] rows(Matrix4dc matrix) {
        return matrix.get(new double[16]);
    }

    private static float[] floats(String name, double[] matrix) {
        float[] cells = new float[16];
        for (int i = 0; i < 16; i++) {
            cells[i] = (float) matrix[i];
            if (!Float.isFinite(cells[i]))
                throw new IllegalArgumentException(
                        "%s: row %d, column %d must be finite, got %s"
                                .formatted(name, i / 4 + 1, i % 4 + 1, matrix[i]));
        }
        return cells;
    }

    /** eye · p = world · (M · p) for a plane p as a column. */
    private static double[][] worldPlanes(List<double[]> eyePlanes, double[] toEye) {
        if (eyePlanes.size() > MOST_PLANES)
            throw new IllegalArgumentException(
                    "at most %d clip planes can cut, got %d"
                            .formatted(MOST_PLANES, eyePlanes.size()));
        double[][] world = new double[eyePlanes.size()][4];
        for (int k = 0; k < world.length; k++) {
            double[] plane = eyePlanes.get(k);
            if (plane.length != 4 || !Arrays.stream(plane).allMatch(Double::isFinite))
                throw new IllegalArgumentException(
                        "plane %d needs four finite numbers, got %s"
                                .formatted(k, Arrays.toString(plane)));
            for (int row = 0; row < 4; row++)
                for (int i = 0; i < 4; i++) world[k][row] += toEye[4 * row + i] * plane[i];
        }
        return world;
    }

    /** Sixteen numbers, row by row. */
    float[] toEye() {
        return toEye;
    }

    float[] normalToEye() {
        return normalToEye;
    }

    float[] toClip() {
        return toClip;
    }

    /** Planes of the user over world points. */
    double[][] worldPlanes() {
        return planes;
    }

    Culling culling() {
        return culling;
    }
}
