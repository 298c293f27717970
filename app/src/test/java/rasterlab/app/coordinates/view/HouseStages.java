package rasterlab.app.coordinates.view;

import org.joml.Matrix4d;
import org.joml.Vector4d;
import rasterlab.engine.scene.House;
import rasterlab.engine.transform.ProjectionMatrices;
import rasterlab.engine.transform.TextbookMatrices;

/**
 * The textbook's stages of the house: world → eye → screen, each as ten rows x, y, z.
 *
 * <p>World is metres times 16. Eye is world turned about x by −90° (z becomes y), about y by −40°
 * and about x by 10°. Screen is eye shifted by −150 along y and divided by H = 1 − z/700, the
 * observer standing at z = 700.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "forming the
 * picture".
 */
final class HouseStages {
    static final double SHIFT_Y = -150;
    static final double R = -1.0 / 700;

    private HouseStages() {}

    /** Row k is vertex k + 1. */
    static double[][] world() {
        return apply(scale());
    }

    static double[][] eye() {
        return apply(eyeMatrix());
    }

    /** The third number is z / H, which the picture does not use. */
    static double[][] screen() {
        return apply(
                ProjectionMatrices.perspective(0, 0, R)
                        .mul(TextbookMatrices.translation(0, SHIFT_Y, 0))
                        .mul(eyeMatrix()));
    }

    /** JOML applies the rightmost factor first. */
    private static Matrix4d eyeMatrix() {
        return TextbookMatrices.rotationX(Math.toRadians(10))
                .mul(TextbookMatrices.rotationY(Math.toRadians(-40)))
                .mul(TextbookMatrices.rotationX(Math.toRadians(-90)))
                .mul(scale());
    }

    private static Matrix4d scale() {
        return TextbookMatrices.scale(House.SCALE, House.SCALE, House.SCALE);
    }

    private static double[][] apply(Matrix4d matrix) {
        double[] metres = House.vertices();
        double[][] rows = new double[metres.length / 3][];
        for (int v = 0; v < rows.length; v++) {
            var point =
                    new Vector4d(metres[3 * v], metres[3 * v + 1], metres[3 * v + 2], 1)
                            .mul(matrix);
            rows[v] = new double[] {point.x / point.w, point.y / point.w, point.z / point.w};
        }
        return rows;
    }
}
