package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.matrix.MatrixParameter.angle;
import static rasterlab.engine.transform.matrix.MatrixParameter.number;
import static rasterlab.engine.transform.matrix.NamedMatrix.space;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.ProjectionMatrices;
import rasterlab.engine.transform.TextbookMatrices;
import rasterlab.engine.transform.matrix.MatrixParameter.ParameterRange;

/** Names of the parallel and central projections. */
final class ProjectionNames {
    private ProjectionNames() {}

    static List<NamedMatrix> all() {
        return Stream.of(straight(), slanted(), central()).flatMap(List::stream).toList();
    }

    private static List<NamedMatrix> straight() {
        Angle quarter = Angle.ofDegrees(90);
        Angle back = quarter.negated();
        return List.of(
                ortho("X", "l", ProjectionMatrices::orthoX),
                ortho("Y", "t", ProjectionMatrices::orthoY),
                ortho("Z", "n", ProjectionMatrices::orthoZ),
                space(
                        "FRONT",
                        "seen from +z: the depth z is dropped",
                        MatrixInverse.NONE,
                        p -> ProjectionMatrices.orthoZ(0)),
                view("BACK", "from −z, y pointing down", TextbookMatrices.scale(1, -1, -1)),
                view("LEFT", "from −x", TextbookMatrices.rotationY(quarter)),
                view("RIGHT", "from +x", TextbookMatrices.rotationY(back)),
                view("TOP", "from +y", TextbookMatrices.rotationX(quarter)),
                view("BOTTOM", "from −y", TextbookMatrices.rotationX(back)));
    }

    private static NamedMatrix ortho(String axis, String cell, Function<Double, Matrix4d> formula) {
        String coordinate = axis.toLowerCase(Locale.ROOT);
        return space(
                "ORTHO" + axis,
                "drops every point along "
                        + coordinate
                        + " onto the plane "
                        + coordinate
                        + " = "
                        + cell,
                MatrixInverse.NONE,
                p -> formula.apply(p[0]),
                number(cell));
    }

    private static NamedMatrix view(String name, String from, Matrix4d matrix) {
        return space(
                name,
                "seen " + from + ", the depth kept in z",
                MatrixInverse.transpose(p -> new Matrix4d(matrix)),
                p -> new Matrix4d(matrix));
    }

    private static List<NamedMatrix> slanted() {
        return List.of(
                turned(
                        "TRIMETRIC",
                        "ROT3DY(alpha) · ROT3DX(beta): three unequal angles between the axes",
                        p ->
                                ProjectionMatrices.trimetric(
                                        Angle.ofDegrees(p[0]), Angle.ofDegrees(p[1])),
                        angle("alpha"),
                        angle("beta")),
                turned(
                        "DIMETRIC",
                        "x and y shortened alike, z to a half: alpha = 22.2077°, beta = 20.7048°",
                        p -> ProjectionMatrices.dimetric()),
                turned(
                        "ISOMETRIC",
                        "all axes shortened alike: alpha = 45°, beta = 35.2644°",
                        p -> ProjectionMatrices.isometric()),
                oblique("CAVALIER", "in full length", ProjectionMatrices.CAVALIER),
                oblique("CABINET", "in half its length", ProjectionMatrices.CABINET));
    }

    private static NamedMatrix turned(
            String name,
            String meaning,
            Function<double[], Matrix4d> formula,
            MatrixParameter... parameters) {
        return space(name, meaning, MatrixInverse.transpose(formula), formula, parameters);
    }

    private static NamedMatrix oblique(String name, String length, double a) {
        return space(
                name,
                "oblique, z slanted by 45° " + length,
                MatrixInverse.space(
                        "the same with both signs in row 3 turned",
                        p -> ProjectionMatrices.oblique(-a)),
                p -> ProjectionMatrices.oblique(a));
    }

    private static List<NamedMatrix> central() {
        return List.of(
                space(
                        "PERSPECTIVE",
                        "H = p·x + q·y + r·z + 1: one vanishing point per number that is not 0",
                        MatrixInverse.space(
                                "PERSPECTIVE(−p, −q, −r)",
                                p -> ProjectionMatrices.perspective(-p[0], -p[1], -p[2])),
                        p -> ProjectionMatrices.perspective(p[0], p[1], p[2]),
                        number("p"),
                        number("q"),
                        number("r")),
                space(
                        "CENTRAL",
                        "x' = k·x / (z + k), the eye at z = −k",
                        MatrixInverse.NONE,
                        p -> ProjectionMatrices.central(p[0]),
                        number("k", ParameterRange.NOT_ZERO)),
                space(
                        "CENTRAL_ORIGIN",
                        "x' = k·x / z, the eye at the origin",
                        MatrixInverse.NONE,
                        p -> ProjectionMatrices.centralFromOrigin(p[0]),
                        number("k", ParameterRange.NOT_ZERO)),
                normalize(),
                space(
                        "CANONICAL",
                        "the pyramid |x|, |y| ≤ z, zmin ≤ z ≤ 1 becomes the box 0 ≤ z ≤ 1",
                        MatrixInverse.space(
                                "rows 3 and 4: 0 0 0 −(1 − zmin)/zmin, 0 0 1 1/zmin",
                                p -> backToThePyramid(p[0])),
                        p -> ProjectionMatrices.canonical(p[0]),
                        number("zmin", ParameterRange.INSIDE_UNIT)));
    }

    private static NamedMatrix normalize() {
        return space(
                "NORMALIZE",
                "the pyramid of a screen 2·xscreen by 2·yscreen at z = a, up to zmax, becomes"
                        + " |x|, |y| ≤ z ≤ 1",
                MatrixInverse.space(
                        "scales of x by zmax·xscreen/a, of y by zmax·yscreen/a, of z by zmax",
                        p -> TextbookMatrices.scale(p[3] * p[1] / p[0], p[3] * p[2] / p[0], p[3])),
                p -> ProjectionMatrices.normalize(p[0], p[1], p[2], p[3]),
                number("a", ParameterRange.POSITIVE),
                number("xscreen", ParameterRange.POSITIVE),
                number("yscreen", ParameterRange.POSITIVE),
                number("zmax", ParameterRange.POSITIVE));
    }

    private static Matrix4d backToThePyramid(double zMin) {
        double h = -(1 - zMin) / zMin;
        return new Matrix4d(
                1, 0, 0, 0, //
                0, 1, 0, 0, //
                0, 0, 0, h, //
                0, 0, 1, 1 / zMin);
    }
}
