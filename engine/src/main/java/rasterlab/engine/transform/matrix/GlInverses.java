package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.TextbookMatrices.scale;
import static rasterlab.engine.transform.TextbookMatrices.translation;

import org.joml.Matrix4d;
import rasterlab.engine.transform.Angle;

/**
 * The ways back from what OpenGL's projections and its viewport make of space.
 *
 * <p>Their parameters stand in the order of {@link ViewNames}: the six sides left, right, bottom,
 * top, near, far; fovy, aspect, near, far; x, y, width, height, n, f.
 */
final class GlInverses {
    static final MatrixInverse ORTHO =
            MatrixInverse.space(
                    "scales by (right − left)/2, (top − bottom)/2, (near − far)/2, then TRANSL3D((left"
                            + " + right)/2, (bottom + top)/2, −(near + far)/2)",
                    GlInverses::ortho);

    static final MatrixInverse FRUSTUM =
            MatrixInverse.space(
                    "with w = right − left, h = top − bottom: rows w/(2·near) 0 0 0, 0 h/(2·near) 0"
                            + " 0, 0 0 0 (near − far)/(2·near·far), (left + right)/(2·near) (bottom"
                            + " + top)/(2·near) −1 (near + far)/(2·near·far)",
                    p ->
                            projection(
                                    (p[1] - p[0]) / 2 / p[4],
                                    (p[3] - p[2]) / 2 / p[4],
                                    (p[0] + p[1]) / 2 / p[4],
                                    (p[2] + p[3]) / 2 / p[4],
                                    p[4],
                                    p[5]));

    static final MatrixInverse PERSPECTIVE =
            MatrixInverse.space(
                    "with t = tan(fovy/2): rows aspect·t 0 0 0, 0 t 0 0, 0 0 0 (near −"
                            + " far)/(2·near·far), 0 0 −1 (near + far)/(2·near·far)",
                    p -> {
                        Angle half = Angle.ofDegrees(p[0] / 2);
                        double t = half.sin() / half.cos();
                        return projection(p[1] * t, t, 0, 0, p[2], p[3]);
                    });

    static final MatrixInverse VIEWPORT =
            MatrixInverse.space(
                    "TRANSL3D(−x − width/2, −y − height/2, −(n + f)/2), then scales by 2/width,"
                            + " 2/height, 2/(f − n); none where n = f",
                    GlInverses::viewport);

    private GlInverses() {}

    private static Matrix4d ortho(double[] p) {
        return translation((p[0] + p[1]) / 2, (p[2] + p[3]) / 2, -(p[4] + p[5]) / 2)
                .mul(scale((p[1] - p[0]) / 2, (p[3] - p[2]) / 2, (p[4] - p[5]) / 2));
    }

    private static Matrix4d projection(
            double wide, double high, double left, double low, double near, double far) {
        double differ = (1 / far - 1 / near) / 2;
        double mean = (1 / far + 1 / near) / 2;
        return new Matrix4d(
                wide, 0, 0, 0, //
                0, high, 0, 0, //
                0, 0, 0, differ, //
                left, low, -1, mean);
    }

    private static Matrix4d viewport(double[] p) {
        return scale(2 / p[2], 2 / p[3], 2 / (p[5] - p[4]))
                .mul(translation(-p[0] - p[2] / 2, -p[1] - p[3] / 2, -(p[4] + p[5]) / 2));
    }
}
