package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.matrix.MatrixParameter.angle;
import static rasterlab.engine.transform.matrix.MatrixParameter.number;
import static rasterlab.engine.transform.matrix.NamedMatrix.plane;

import java.util.List;
import org.joml.Matrix3d;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.PlaneMatrices;

/** Names of the 3×3 matrices of the plane. */
final class PlaneNames {
    private PlaneNames() {}

    static List<NamedMatrix> all() {
        return List.of(
                plane(
                        "IDENTITY2D",
                        "leaves every point of the plane where it is",
                        MatrixInverse.plane("IDENTITY2D", p -> PlaneMatrices.scale(1, 1)),
                        p -> PlaneMatrices.scale(1, 1)),
                plane(
                        "ROT2D",
                        "turns counter-clockwise about the origin",
                        MatrixInverse.plane(
                                "ROT2D(−angle)",
                                p -> PlaneMatrices.rotation(Angle.ofDegrees(-p[0]))),
                        p -> PlaneMatrices.rotation(Angle.ofDegrees(p[0])),
                        angle("angle")),
                plane(
                        "SCALE2D",
                        "stretches x and y",
                        MatrixInverse.plane(
                                "SCALE2D(1/x, 1/y); none where x·y = 0",
                                p -> PlaneMatrices.scale(1 / p[0], 1 / p[1])),
                        p -> PlaneMatrices.scale(p[0], p[1]),
                        number("x"),
                        number("y")),
                plane(
                        "REFL2DX",
                        "reflects in the x axis",
                        MatrixInverse.plane("REFL2DX", p -> PlaneMatrices.scale(1, -1)),
                        p -> PlaneMatrices.scale(1, -1)),
                plane(
                        "REFL2DY",
                        "reflects in the y axis",
                        MatrixInverse.plane("REFL2DY", p -> PlaneMatrices.scale(-1, 1)),
                        p -> PlaneMatrices.scale(-1, 1)),
                plane(
                        "SHEAR2D",
                        "shears by b along y and by c along x: x' = x + c·y, y' = b·x + y",
                        MatrixInverse.plane(
                                "SHEAR2D(−b, −c) and then SCALE2D by 1/(1 − b·c); none where b·c = 1",
                                p -> backSheared(p[0], p[1])),
                        p -> PlaneMatrices.shear(p[0], p[1]),
                        number("b"),
                        number("c")),
                plane(
                        "TRANSL2D",
                        "moves by (m, n)",
                        MatrixInverse.plane(
                                "TRANSL2D(−m, −n)", p -> PlaneMatrices.translation(-p[0], -p[1])),
                        p -> PlaneMatrices.translation(p[0], p[1]),
                        number("m"),
                        number("n")));
    }

    private static Matrix3d backSheared(double b, double c) {
        double by = 1 / (1 - b * c);
        return PlaneMatrices.of(by, -b * by, -c * by, by);
    }
}
