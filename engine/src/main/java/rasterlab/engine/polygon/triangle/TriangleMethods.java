package rasterlab.engine.polygon.triangle;

import java.util.List;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that tell whether a point is in a triangle, in teaching order. */
final class TriangleMethods {
    private static final String TRAEGER =
            "D. Träger's idea of 2005, told in the course's text on analytic geometry";

    private TriangleMethods() {}

    static List<Method<PointInTriangle>> all() {
        return List.of(
                halfPlane(), rotation(), simplex(), signInt(), signFloat(), signDouble(), robust());
    }

    private static Method<PointInTriangle> halfPlane() {
        return new Method<>(
                "half-plane",
                new About(
                        "f(x, y) = L·x + M·y + N ≤ 0 for each side, negated where the third corner"
                                + " has f > 0",
                        "the triangle lies where no f is positive",
                        "6 multiplications and 7 additions per side, up to three sides",
                        "points within rounding of a side; corners on one line: the whole line is"
                                + " inside; products beyond 10³⁰⁸ or below 10⁻³⁰⁸",
                        "the course's text on analytic geometry, first method"),
                new HalfPlanes());
    }

    private static Method<PointInTriangle> rotation() {
        return new Method<>(
                "rotation",
                new About(
                        "x' = x·cos t − y·sin t, t turning a corner onto the Oy axis; the other"
                                + " two need x' of different signs",
                        "the point stays at the origin, the triangle turns about it",
                        "arc tangent, sine and cosine of one angle, 6 multiplications and 9 additions"
                                + " per corner, up to three",
                        "rounded sines, by which a point on a side falls to either",
                        "the course's text on analytic geometry, second method, 1991"),
                new Rotation());
    }

    private static Method<PointInTriangle> simplex() {
        return new Method<>(
                "simplex",
                new About(
                        "(u v) = (x y)·M⁻¹; inside where u ≥ 0, v ≥ 0, u + v ≤ 1",
                        "the map takes the triangle to (0, 0), (1, 0), (0, 1)",
                        "4 multiplications, 8 additions and a division, or 6, up to 10 and 2",
                        "no area, which is refused; points within rounding of a side",
                        "D. Chistyakov's suggestion of 1999, told in the course's text on analytic"
                                + " geometry"),
                new Simplex());
    }

    private static Method<PointInTriangle> signInt() {
        return new Method<>(
                "sign-int",
                new About(
                        "(s₁ xor s₂) ≥ 0 and (s₁ xor s₃) ≥ 0, s = (y − py)·(qx − px) − (x − px)·(qy"
                                + " − py)",
                        "inside, all three sides turn the same way",
                        "4 multiplications and 10 subtractions, or 6 and 15",
                        "int overflow past ±2¹⁵; the boundary is inside for one direction of the"
                                + " corners and outside for the other; corners on one line; refuses"
                                + " fractions",
                        TRAEGER),
                new SignInt());
    }

    private static Method<PointInTriangle> signFloat() {
        return new Method<>(
                "sign-float",
                new About(
                        "sign-int in 24-bit floats, by the exclusive or of their bits",
                        "inside, all three sides turn the same way",
                        "4 multiplications and 10 subtractions, or 6 and 15",
                        "coordinates that need more than 24 bits; −0.0 counts as negative; corners"
                                + " on one line",
                        TRAEGER),
                new SignFloat());
    }

    private static Method<PointInTriangle> signDouble() {
        return new Method<>(
                "sign-double",
                new About(
                        "sign-int in 53-bit doubles, by the exclusive or of their bits",
                        "inside, all three sides turn the same way",
                        "4 multiplications and 10 subtractions, or 6 and 15",
                        "−0.0 counts as negative, so boundary points fall to either; rounding near"
                                + " a side; corners on one line; products beyond 10³⁰⁸ or 10⁻³⁰⁸",
                        TRAEGER),
                new SignDouble());
    }

    private static Method<PointInTriangle> robust() {
        return new Method<>(
                "robust",
                new About(
                        "exact signs of o(a, b, p), o(b, c, p), o(c, a, p); inside where no two"
                                + " differ",
                        "the three doubled areas add up to the triangle's",
                        "14 multiplications and 25 additions for the three sides and the error"
                                + " bound; exact orientations only within rounding of a side",
                        "none known for finite doubles",
                        "exact signs after J. R. Shewchuk, Adaptive precision floating-point"
                                + " arithmetic and fast robust geometric predicates, 1997"),
                new RobustTriangle());
    }
}
