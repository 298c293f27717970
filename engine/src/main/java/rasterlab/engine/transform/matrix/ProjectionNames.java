package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.matrix.MatrixParameter.angle;
import static rasterlab.engine.transform.matrix.MatrixParameter.number;
import static rasterlab.engine.transform.matrix.NamedMatrix.SINGULAR;
import static rasterlab.engine.transform.matrix.NamedMatrix.space;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.ProjectionMatrices;
import rasterlab.engine.transform.TextbookMatrices;
import rasterlab.engine.transform.matrix.MatrixParameter.Range;

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
                ortho("X", "l", ProjectionMatrices.orthoX(0)),
                ortho("Y", "t", ProjectionMatrices.orthoY(0)),
                ortho("Z", "n", ProjectionMatrices.orthoZ(0)),
                space(
                        "FRONT",
                        "seen from +z: the depth z is dropped",
                        SINGULAR,
                        p -> ProjectionMatrices.orthoZ(0)),
                view("BACK", "from −z, y pointing down", TextbookMatrices.scale(1, -1, -1)),
                view("LEFT", "from −x", TextbookMatrices.rotationY(quarter)),
                view("RIGHT", "from +x", TextbookMatrices.rotationY(back)),
                view("TOP", "from +y", TextbookMatrices.rotationX(quarter)),
                view("BOTTOM", "from −y", TextbookMatrices.rotationX(back)));
    }

    private static NamedMatrix ortho(String axis, String cell, Matrix4d flat) {
        String coordinate = axis.toLowerCase(Locale.ROOT);
        int place = "XYZ".indexOf(axis);
        return space(
                "ORTHO" + axis,
                "drops every point along "
                        + coordinate
                        + " onto the plane "
                        + coordinate
                        + " = "
                        + cell,
                SINGULAR,
                p -> new Matrix4d(flat).set(3, place, p[0]),
                number(cell));
    }

    private static NamedMatrix view(String name, String from, Matrix4d matrix) {
        return space(
                name,
                "seen " + from + ", the depth kept in z",
                "its transpose",
                p -> new Matrix4d(matrix));
    }

    private static List<NamedMatrix> slanted() {
        return List.of(
                space(
                        "TRIMETRIC",
                        "ROT3DY(alpha) · ROT3DX(beta): three unequal angles between the axes",
                        "its transpose",
                        p ->
                                ProjectionMatrices.trimetric(
                                        Angle.ofDegrees(p[0]), Angle.ofDegrees(p[1])),
                        angle("alpha"),
                        angle("beta")),
                space(
                        "DIMETRIC",
                        "x and y shortened alike, z to a half: alpha = 22.2077°, beta = 20.7048°",
                        "its transpose",
                        p -> ProjectionMatrices.dimetric()),
                space(
                        "ISOMETRIC",
                        "all axes shortened alike: alpha = 45°, beta = 35.2644°",
                        "its transpose",
                        p -> ProjectionMatrices.isometric()),
                space(
                        "CAVALIER",
                        "oblique, z slanted by 45° in full length",
                        "the same with both signs in row 3 turned",
                        p -> ProjectionMatrices.cavalier()),
                space(
                        "CABINET",
                        "oblique, z slanted by 45° in half its length",
                        "the same with both signs in row 3 turned",
                        p -> ProjectionMatrices.cabinet()));
    }

    private static List<NamedMatrix> central() {
        return List.of(
                space(
                        "PERSPECTIVE",
                        "H = p·x + q·y + r·z + 1: one vanishing point per number that is not 0",
                        "PERSPECTIVE(−p, −q, −r)",
                        p -> ProjectionMatrices.perspective(p[0], p[1], p[2]),
                        number("p"),
                        number("q"),
                        number("r")),
                space(
                        "CENTRAL",
                        "x' = k·x / (z + k), the eye at z = −k",
                        SINGULAR,
                        p -> ProjectionMatrices.central(p[0]),
                        number("k", Range.NOT_ZERO)),
                space(
                        "CENTRAL_ORIGIN",
                        "x' = k·x / z, the eye at the origin",
                        SINGULAR,
                        p -> ProjectionMatrices.centralFromOrigin(p[0]),
                        number("k", Range.NOT_ZERO)),
                space(
                        "CANONICAL",
                        "the pyramid |x|, |y| ≤ z, zmin ≤ z ≤ 1 becomes the box 0 ≤ z ≤ 1",
                        "rows 3 and 4: 0 0 0 −(1 − zmin)/zmin, 0 0 1 1/zmin",
                        p -> ProjectionMatrices.canonical(p[0]),
                        number("zmin", Range.INSIDE_UNIT)));
    }
}
