package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.exact.BigTrig.DIGITS;
import static rasterlab.engine.transform.matrix.ExactMatrices.diagonal;
import static rasterlab.engine.transform.matrix.ExactMatrices.shift;
import static rasterlab.engine.transform.matrix.ExactMatrices.turn;

import java.math.BigDecimal;
import rasterlab.engine.transform.exact.BigMatrix;
import rasterlab.engine.transform.exact.BigTrig;

/** Projections and views to 60 digits, as products of simple matrices. */
final class ExactViews {
    private ExactViews() {}

    static BigMatrix of(String name, double... p) {
        return switch (name) {
            case "ORTHOX" -> diagonal(0, 1, 1, 1).then(shift(p[0], 0, 0));
            case "ORTHOY" -> diagonal(1, 0, 1, 1).then(shift(0, p[0], 0));
            case "ORTHOZ" -> diagonal(1, 1, 0, 1).then(shift(0, 0, p[0]));
            case "FRONT" -> diagonal(1, 1, 0, 1);
            case "BACK" -> turn('X', turn(180));
            case "LEFT" -> turn('Y', turn(90));
            case "RIGHT" -> turn('Y', turn(-90));
            case "TOP" -> turn('X', turn(90));
            case "BOTTOM" -> turn('X', turn(-90));
            case "TRIMETRIC" -> turn('Y', turn(p[0])).then(turn('X', turn(p[1])));
            case "DIMETRIC" -> bySquaredSines("1", "7", "1", "8");
            case "ISOMETRIC" -> bySquaredSines("1", "2", "1", "3");
            case "CAVALIER" -> oblique(turn(45).cos());
            case "CABINET" -> oblique(turn(45).cos().divide(BigDecimal.valueOf(2)));
            case "PERSPECTIVE" -> perspective(p[0], p[1], p[2]);
            case "CENTRAL" -> central(p[0]);
            case "CENTRAL_ORIGIN" -> shift(0, 0, -p[0]).then(central(p[0]));
            case "NORMALIZE" -> normalize(big(p[0]), big(p[1]), big(p[2]), big(p[3]));
            case "CANONICAL" -> canonical(big(p[0]));
            case "VIEW_LEFT" -> view(p, 1);
            case "VIEW_RIGHT" -> view(p, -1);
            default -> ExactGl.of(name, p);
        };
    }

    static BigDecimal big(double value) {
        return new BigDecimal(value);
    }

    static BigDecimal ratio(BigDecimal part, BigDecimal of) {
        return part.divide(of, DIGITS);
    }

    private static BigMatrix bySquaredSines(String a, String of, String b, String per) {
        return bySine('Y', ratio(new BigDecimal(a), new BigDecimal(of)))
                .then(bySine('X', ratio(new BigDecimal(b), new BigDecimal(per))));
    }

    private static BigMatrix bySine(char axis, BigDecimal squaredSine) {
        return turn(
                axis, squaredSine.sqrt(DIGITS), BigDecimal.ONE.subtract(squaredSine).sqrt(DIGITS));
    }

    private static BigMatrix oblique(BigDecimal a) {
        BigMatrix matrix = BigMatrix.identity(4);
        matrix.rows()[2][0] = a.negate();
        matrix.rows()[2][1] = a.negate();
        return matrix;
    }

    private static BigMatrix perspective(Object p, Object q, Object r) {
        return BigMatrix.of(4, 1, 0, 0, p, 0, 1, 0, q, 0, 0, 1, r, 0, 0, 0, 1);
    }

    /** k·(x, y) over z + k. */
    private static BigMatrix central(double k) {
        return BigMatrix.of(4, k, 0, 0, 0, 0, k, 0, 0, 0, 0, 0, 1, 0, 0, 0, k);
    }

    /** First z_max becomes 1, then the screen, now at a/z_max, is pulled out to x = z, y = z. */
    private static BigMatrix normalize(
            BigDecimal a, BigDecimal xScreen, BigDecimal yScreen, BigDecimal zMax) {
        BigDecimal far = ratio(BigDecimal.ONE, zMax);
        return diagonal(far, far, far, 1)
                .then(diagonal(ratio(a, xScreen), ratio(a, yScreen), 1, 1));
    }

    private static BigMatrix canonical(BigDecimal zMin) {
        BigDecimal deep = BigDecimal.ONE.subtract(zMin);
        BigMatrix matrix = diagonal(1, 1, ratio(BigDecimal.ONE, deep), 0);
        matrix.rows()[2][3] = BigDecimal.ONE;
        matrix.rows()[3][2] = ratio(zMin, deep).negate();
        return matrix;
    }

    /** The textbook's four steps: about z, about x, back by ρ, x turned round (and y as well). */
    private static BigMatrix view(double[] p, int up) {
        BigTrig theta = turn(p[0]);
        BigTrig phi = turn(p[1]);
        return turn('Z', theta.cos(), theta.sin())
                .then(turn('X', phi.sin().negate(), phi.cos().negate()))
                .then(shift(0, 0, p[2]))
                .then(diagonal(-1, up, 1, 1));
    }
}
