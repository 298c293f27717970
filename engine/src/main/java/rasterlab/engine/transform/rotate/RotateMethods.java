package rasterlab.engine.transform.rotate;

import java.util.List;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class RotateMethods {
    private static final String CHAPTER =
            "Kazantsev, course text on computer graphics, chapter 3, efficiency of computing";

    private RotateMethods() {}

    static List<Method<PlaneRotation>> all() {
        return List.of(
                direct(),
                floating(),
                table(),
                bunemanTextbook(),
                buneman(),
                orthonormal(),
                quaternion(),
                totalAngle());
    }

    private static Method<PlaneRotation> direct() {
        return new Method<>(
                "direct",
                new About(
                        "x' = x·cos θ − y·sin θ, y' = x·sin θ + y·cos θ",
                        "x² + y² stays, but for rounding",
                        "2 additions and 4 multiplications per turn",
                        "drifts, as n turns add up n roundings of radius and angle",
                        CHAPTER),
                new DirectRotation());
    }

    private static Method<PlaneRotation> floating() {
        return new Method<>(
                "float",
                new About(
                        "x' = x·cos θ − y·sin θ, y' = x·sin θ + y·cos θ in float",
                        "x² + y² stays, but for rounding",
                        "2 additions and 4 multiplications per turn",
                        "drifts 2²⁹ times as fast as in double; refuses coordinates above 2¹²⁰",
                        CHAPTER),
                new FloatRotation());
    }

    private static Method<PlaneRotation> table() {
        return new Method<>(
                "table",
                new About(
                        "the direct formula with the sine and cosine of the nearest whole degree",
                        "x² + y² stays, but for rounding",
                        "2 additions and 4 multiplications per turn, no sine",
                        "angles between whole degrees, off by up to half a degree per turn",
                        CHAPTER),
                new TableRotation());
    }

    private static Method<PlaneRotation> bunemanTextbook() {
        return new Method<>(
                "buneman-textbook",
                new About(
                        "T = y + x·t, x' = x − T·sin θ, y' = x'·t + T, t = tan θ/2",
                        "three shears of area 1",
                        "3 additions and 3 multiplications per turn",
                        "tan 90° at θ = 180°, and every angle close to it",
                        CHAPTER),
                new BunemanTextbookRotation());
    }

    private static Method<PlaneRotation> buneman() {
        return new Method<>(
                "buneman",
                new About(
                        "T = y + x·t, x' = x − T·sin θ, y' = x'·t + T, t = tan θ/2; beyond 90°"
                                + " signs are changed and θ − 180° is turned",
                        "|t| ≤ 1; three shears of area 1",
                        "3 additions and 3 multiplications per turn",
                        "drifts, as n turns add up n roundings of the angle",
                        "A. Paeth, A fast algorithm for general raster rotation, Graphics"
                                + " Interface 1986"),
                new BunemanRotation());
    }

    private static Method<PlaneRotation> orthonormal() {
        return new Method<>(
                "orthonormal",
                new About(
                        "M ← M·R, made orthonormal again by (3 − c² − s²)/2; p' = p·M at the end",
                        "c² + s² = 1",
                        "4 additions and 9 multiplications per further turn, however many points",
                        "drifts in its angle, as n turns add up n roundings of θ",
                        "D. F. Rogers, J. A. Adams, Mathematical Elements for Computer Graphics,"
                                + " 1976"),
                new OrthonormalRotation());
    }

    private static Method<PlaneRotation> quaternion() {
        return new Method<>(
                "quaternion",
                new About(
                        "q ← q·r, normalised; cos = w² − z², sin = 2·w·z at the end",
                        "w² + z² = 1",
                        "4 additions and 9 multiplications per further turn, however many points",
                        "drifts in its angle, as n turns add up n roundings of θ/2",
                        "K. Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985"),
                new QuaternionRotation());
    }

    private static Method<PlaneRotation> totalAngle() {
        return new Method<>(
                "total-angle",
                new About(
                        "one turn by n·θ, whole turns taken off exactly",
                        "the angle is exact until its sine is taken",
                        "2 additions and 4 multiplications, however many turns",
                        "none known",
                        "T. J. Dekker, A floating-point technique for extending the available"
                                + " precision, Numerische Mathematik 18, 1971 (exact products)"),
                new TotalAngleRotation());
    }
}
