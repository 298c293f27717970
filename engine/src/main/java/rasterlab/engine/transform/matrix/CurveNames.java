package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.matrix.NamedMatrix.space;

import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4d;
import rasterlab.engine.spline.curve.CurveMatrix;

/**
 * Names of the matrices of cubic curves: {@code [t³ t² t 1] · M · G}.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 8;
 * G holds P1, P4, R1, R4 for Hermite and P1 to P4 for Bézier.
 */
final class CurveNames {
    private static final double THIRD = 1 / 3.0;

    private CurveNames() {}

    static List<NamedMatrix> all() {
        return List.of(
                space(
                        "HERMITE",
                        "a cubic curve by its ends P1, P4 and its tangents R1, R4 there",
                        inverse(
                                "rows [t³ t² t 1] for P1, P4 and its derivative for R1, R4: 0 0 0 1,"
                                        + " 1 1 1 1, 0 0 1 0, 3 2 1 0",
                                new Matrix4d(
                                        0, 0, 0, 1, //
                                        1, 1, 1, 1, //
                                        0, 0, 1, 0, //
                                        3, 2, 1, 0)),
                        p -> matrix(CurveMatrix.hermite())),
                space(
                        "BEZIER",
                        "a cubic curve by four points P1 to P4: HERMITE · HERMITE_BEZIER",
                        inverse(
                                "rows for P1 to P4: 0 0 0 1, 0 0 1/3 1, 0 1/3 2/3 1, 1 1 1 1",
                                new Matrix4d(
                                        0, 0, 0, 1, //
                                        0, 0, THIRD, 1, //
                                        0, THIRD, 2 * THIRD, 1, //
                                        1, 1, 1, 1)),
                        p -> matrix(CurveMatrix.bezier(3))),
                space(
                        "HERMITE_BEZIER",
                        "ends and tangents of the curve with four Bézier points",
                        inverse(
                                "P1, P1 + R1/3, P4 − R4/3, P4: rows 1 0 0 0, 1 0 1/3 0, 0 1 0 −1/3,"
                                        + " 0 1 0 0",
                                new Matrix4d(
                                        1, 0, 0, 0, //
                                        1, 0, THIRD, 0, //
                                        0, 1, 0, -THIRD, //
                                        0, 1, 0, 0)),
                        p -> matrix(CurveMatrix.hermiteOfBezier())));
    }

    private static MatrixInverse inverse(String text, Matrix4d matrix) {
        return MatrixInverse.space(text, p -> new Matrix4d(matrix));
    }

    private static Matrix4d matrix(double[][] rows) {
        return new Matrix4d().set(Arrays.stream(rows).flatMapToDouble(Arrays::stream).toArray());
    }
}
