package rasterlab.engine.signmap;

import java.math.BigDecimal;
import java.util.List;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.predicate.Spacing;

/**
 * The side of a plane that (x, y, ½) lies on, near (½, ½, ½), which is in the plane: the sign of
 * {@code n·p − c}.
 *
 * <p>The plane {@code 3(x − ½) − 2(y − ½) + (z − ½) = 0} is given by three of its points, a, b and
 * c, so that no method is told its coefficients.
 */
final class PlaneSideForms {
    private static final double HEIGHT = 0.5;
    private static final Vector A = new Vector(12.5, 24.5, 12.5);
    private static final Vector B = new Vector(24.5, 12.5, -47.5);
    private static final Vector C = new Vector(-11.5, 6.5, 48.5);
    private static final Plane PLANE = Plane.through(A, B, C);

    private PlaneSideForms() {}

    static SignSubject subject() {
        return new FormSigns(
                "side-of-plane",
                "a = (12.5, 24.5, 12.5), b = (24.5, 12.5, −47.5), c = (−11.5, 6.5, 48.5), z = 0.5",
                List.of(
                        new SignForm("constant", Spacing.DOUBLE, PlaneSideForms::constant),
                        new SignForm("point", Spacing.DOUBLE, PlaneSideForms::point),
                        new SignForm("determinant", Spacing.DOUBLE, PlaneSideForms::determinant),
                        new SignForm("float", Spacing.FLOAT, PlaneSideForms::inFloat)),
                PlaneSideForms::exact);
    }

    /** Compares n·p with the constant c = n·b. */
    private static int constant(double x, double y) {
        return OrientationForms.sign(PLANE.side(new Vector(x, y, HEIGHT)));
    }

    /** The sign of n·(p − b). */
    private static int point(double x, double y) {
        return OrientationForms.sign(PLANE.normal().dot(new Vector(x, y, HEIGHT).minus(B)));
    }

    /** The sign of ((a − p) × (b − p))·(c − p), turned to that of the normal. */
    private static int determinant(double x, double y) {
        var p = new Vector(x, y, HEIGHT);
        return -OrientationForms.sign(A.minus(p).cross(B.minus(p)).dot(C.minus(p)));
    }

    private static int inFloat(double x, double y) {
        float nx = (float) PLANE.normal().x();
        float ny = (float) PLANE.normal().y();
        float nz = (float) PLANE.normal().z();
        float sum = nx * (float) x + ny * (float) y + nz * (float) HEIGHT;
        return OrientationForms.sign(sum - (float) PLANE.c());
    }

    /** The sign of 3(x − ½) − 2(y − ½), turned to that of the normal, in decimals of any length. */
    private static int exact(double x, double y) {
        var half = new BigDecimal(HEIGHT);
        BigDecimal across = new BigDecimal(x).subtract(half).multiply(new BigDecimal(3));
        BigDecimal up = new BigDecimal(y).subtract(half).multiply(new BigDecimal(2));
        return across.compareTo(up) * (PLANE.normal().x() > 0 ? 1 : -1);
    }
}
