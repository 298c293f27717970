package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.matrix.MatrixParameter.angle;
import static rasterlab.engine.transform.matrix.MatrixParameter.number;
import static rasterlab.engine.transform.matrix.MatrixParameter.vector;
import static rasterlab.engine.transform.matrix.NamedMatrix.space;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Directions;
import rasterlab.engine.transform.TextbookMatrices;
import rasterlab.engine.transform.matrix.MatrixParameter.ParameterRange;

/** Names of the 4×4 matrices of motion, scale and reflection. */
final class SpaceNames {
    private SpaceNames() {}

    static List<NamedMatrix> all() {
        return List.of(
                space(
                        "IDENTITY",
                        "leaves every point where it is",
                        MatrixInverse.space("IDENTITY", p -> new Matrix4d()),
                        p -> new Matrix4d()),
                rotation("X", TextbookMatrices::rotationX),
                rotation("Y", TextbookMatrices::rotationY),
                rotation("Z", TextbookMatrices::rotationZ),
                scale("X", "a", a -> TextbookMatrices.scale(a, 1, 1)),
                scale("Y", "e", e -> TextbookMatrices.scale(1, e, 1)),
                scale("Z", "j", j -> TextbookMatrices.scale(1, 1, j)),
                space(
                        "SCALE3D",
                        "H = s: everything is scaled by 1/s",
                        MatrixInverse.space(
                                "SCALE3D(1/s)", p -> TextbookMatrices.uniformScale(1 / p[0])),
                        p -> TextbookMatrices.uniformScale(p[0]),
                        number("s", ParameterRange.NOT_ZERO)),
                reflection("XY", TextbookMatrices.scale(1, 1, -1)),
                reflection("YZ", TextbookMatrices.scale(-1, 1, 1)),
                reflection("ZX", TextbookMatrices.scale(1, -1, 1)),
                space(
                        "TRANSL3D",
                        "moves by (l, m, n)",
                        MatrixInverse.space(
                                "TRANSL3D(−l, −m, −n)",
                                p -> TextbookMatrices.translation(-p[0], -p[1], -p[2])),
                        p -> TextbookMatrices.translation(p[0], p[1], p[2]),
                        number("l"),
                        number("m"),
                        number("n")),
                space(
                        "ROTAXIS",
                        "turns about the line through a point in a direction of any length but 0",
                        MatrixInverse.space(
                                "ROTAXIS(through, direction, −angle)", p -> aboutAxis(p, -p[6])),
                        p -> aboutAxis(p, p[6]),
                        vector("through"),
                        vector("direction"),
                        angle("angle")));
    }

    private static Matrix4d aboutAxis(double[] p, double degrees) {
        var direction = new Vector3d(p[3], p[4], p[5]);
        if (p[3] == 0 && p[4] == 0 && p[5] == 0)
            throw new IllegalArgumentException("direction must not be zero, got (0, 0, 0)");
        return TextbookMatrices.rotationAbout(
                new Vector3d(p[0], p[1], p[2]),
                Directions.unit(direction),
                Angle.ofDegrees(degrees));
    }

    private static NamedMatrix rotation(String axis, Function<Angle, Matrix4d> formula) {
        return space(
                "ROT3D" + axis,
                "turns about the %s axis, counter-clockwise seen from its positive end"
                        .formatted(axis.toLowerCase(Locale.ROOT)),
                MatrixInverse.space(
                        "ROT3D" + axis + "(−angle)", p -> formula.apply(Angle.ofDegrees(-p[0]))),
                p -> formula.apply(Angle.ofDegrees(p[0])),
                angle("angle"));
    }

    private static NamedMatrix scale(String axis, String cell, Function<Double, Matrix4d> formula) {
        String name = "SCALE3D" + axis;
        return space(
                name,
                "stretches " + axis.toLowerCase(Locale.ROOT),
                MatrixInverse.space(
                        name + "(1/" + cell + "); none where " + cell + " = 0",
                        p -> formula.apply(1 / p[0])),
                p -> formula.apply(p[0]),
                number(cell));
    }

    private static NamedMatrix reflection(String plane, Matrix4d matrix) {
        return space(
                "REFL3D" + plane,
                "reflects in the plane " + plane,
                MatrixInverse.space("REFL3D" + plane, p -> new Matrix4d(matrix)),
                p -> new Matrix4d(matrix));
    }
}
