package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.matrix.NamedMatrix.space;

import java.util.List;
import org.joml.Matrix4d;

/**
 * Names of the matrices of cubic curves: {@code [t³ t² t 1] · M · G}.
 *
 * <p>Source: Kazantsev, course text on computer graphics, chapter 8; G holds P1, P4, R1, R4 for
 * Hermite and P1 to P4 for Bézier.
 */
final class CurveNames {
    private CurveNames() {}

    static List<NamedMatrix> all() {
        return List.of(
                space(
                        "HERMITE",
                        "a cubic curve by its ends P1, P4 and its tangents R1, R4 there",
                        "exists",
                        p -> new Matrix4d(2, -2, 1, 1, -3, 3, -2, -1, 0, 0, 1, 0, 1, 0, 0, 0)),
                space(
                        "BEZIER",
                        "a cubic curve by four points P1 to P4: HERMITE · HERMITE_BEZIER",
                        "exists",
                        p -> new Matrix4d(-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0)),
                space(
                        "HERMITE_BEZIER",
                        "ends and tangents of the curve with four Bézier points",
                        "exists",
                        p -> new Matrix4d(1, 0, 0, 0, 0, 0, 0, 1, -3, 3, 0, 0, 0, 0, -3, 3)));
    }
}
