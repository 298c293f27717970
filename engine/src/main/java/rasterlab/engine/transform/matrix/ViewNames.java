package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.matrix.MatrixParameter.angle;
import static rasterlab.engine.transform.matrix.MatrixParameter.number;
import static rasterlab.engine.transform.matrix.MatrixParameter.vector;
import static rasterlab.engine.transform.matrix.NamedMatrix.space;

import java.util.List;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.GlMatrices;
import rasterlab.engine.transform.TextbookMatrices;
import rasterlab.engine.transform.ViewMatrices;
import rasterlab.engine.transform.matrix.MatrixParameter.ParameterRange;

/** Names of the matrices from the world to the eye and from there to the window. */
final class ViewNames {
    private ViewNames() {}

    static List<NamedMatrix> all() {
        return List.of(
                space(
                        "VIEW_LEFT",
                        "VP_L: to the left-handed eye at rho, phi from the z axis, theta about it",
                        MatrixInverse.space(
                                "TRANSL3D(0, 0, −rho), then the transposed turn",
                                p -> back(ViewMatrices::left, p)),
                        p -> ViewMatrices.left(Angle.ofDegrees(p[0]), Angle.ofDegrees(p[1]), p[2]),
                        angle("theta"),
                        angle("phi"),
                        number("rho", ParameterRange.POSITIVE)),
                space(
                        "VIEW_RIGHT",
                        "VP_R: the same with y pointing down, right-handed",
                        MatrixInverse.space(
                                "TRANSL3D(0, 0, −rho), then the transposed turn",
                                p -> back(ViewMatrices::right, p)),
                        p -> ViewMatrices.right(Angle.ofDegrees(p[0]), Angle.ofDegrees(p[1]), p[2]),
                        angle("theta"),
                        angle("phi"),
                        number("rho", ParameterRange.POSITIVE)),
                space(
                        "LOOKAT",
                        "to the eye that looks at center, up pointing upward, z backward",
                        MatrixInverse.space(
                                "the transposed turn, then TRANSL3D(eye)",
                                p -> backFrom(p[0], p[1], p[2], looking(p))),
                        ViewNames::looking,
                        vector("eye"),
                        vector("center"),
                        vector("up")),
                space(
                        "GL_ORTHO",
                        "the box left..right, bottom..top, −near..−far becomes −1..1",
                        GlInverses.ORTHO,
                        p -> GlMatrices.ortho(p[0], p[1], p[2], p[3], p[4], p[5]),
                        sides(ParameterRange.ANY)),
                space(
                        "GL_FRUSTUM",
                        "the cut pyramid through left..right, bottom..top at −near becomes −1..1",
                        GlInverses.FRUSTUM,
                        p -> GlMatrices.frustum(p[0], p[1], p[2], p[3], p[4], p[5]),
                        sides(ParameterRange.POSITIVE)),
                space(
                        "GL_PERSPECTIVE",
                        "the same for a straight look, fovy degrees high, aspect times as wide",
                        GlInverses.PERSPECTIVE,
                        p -> GlMatrices.perspective(p[0], p[1], p[2], p[3]),
                        number("fovy", ParameterRange.HALF_TURN),
                        number("aspect", ParameterRange.POSITIVE),
                        number("near", ParameterRange.POSITIVE),
                        number("far", ParameterRange.POSITIVE)),
                viewport());
    }

    private static NamedMatrix viewport() {
        return space(
                "VIEWPORT",
                "−1..1 becomes pixels from the bottom left, depth n..f (0 and 1 if left out)",
                GlInverses.VIEWPORT,
                p -> GlMatrices.viewport(p[0], p[1], p[2], p[3], p[4], p[5]),
                number("x"),
                number("y"),
                number("width", ParameterRange.POSITIVE),
                number("height", ParameterRange.POSITIVE),
                number("n", ParameterRange.UNIT).or(0),
                number("f", ParameterRange.UNIT).or(1));
    }

    private interface Spherical {
        Matrix4d of(Angle theta, Angle phi, double rho);
    }

    private static Matrix4d back(Spherical view, double[] p) {
        Matrix4d turn = view.of(Angle.ofDegrees(p[0]), Angle.ofDegrees(p[1]), 0);
        return turn.transpose().mul(TextbookMatrices.translation(0, 0, -p[2]));
    }

    private static Matrix4d looking(double[] p) {
        return ViewMatrices.lookAt(point(p, 0), point(p, 3), point(p, 6));
    }

    private static Matrix4d backFrom(double x, double y, double z, Matrix4d look) {
        return TextbookMatrices.translation(x, y, z).mul(look.setTranslation(0, 0, 0).transpose());
    }

    private static MatrixParameter[] sides(ParameterRange distance) {
        return new MatrixParameter[] {
            number("left"),
            number("right"),
            number("bottom"),
            number("top"),
            number("near", distance),
            number("far", distance)
        };
    }

    private static Vector3d point(double[] p, int from) {
        return new Vector3d(p[from], p[from + 1], p[from + 2]);
    }
}
