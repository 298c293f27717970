package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.exact.BigTrig.DIGITS;

import java.math.BigDecimal;
import java.util.Arrays;
import rasterlab.engine.transform.exact.BigAxis;
import rasterlab.engine.transform.exact.BigMatrix;
import rasterlab.engine.transform.exact.BigTrig;

/**
 * Every named matrix to 60 digits, composed of turns, stretches and shifts where the formulas are
 * written out in one piece. Shares no code with them.
 */
final class ExactMatrices {
    private ExactMatrices() {}

    static BigMatrix of(String name, double... p) {
        return switch (name) {
            case "IDENTITY2D" -> BigMatrix.identity(3);
            case "ROT2D" -> plane(turn(p[0]));
            case "SCALE2D" -> BigMatrix.of(3, p[0], 0, 0, 0, p[1], 0, 0, 0, 1);
            case "REFL2DX" -> BigMatrix.of(3, 1, 0, 0, 0, -1, 0, 0, 0, 1);
            case "REFL2DY" -> BigMatrix.of(3, -1, 0, 0, 0, 1, 0, 0, 0, 1);
            case "SHEAR2D" -> BigMatrix.of(3, 1, p[0], 0, p[1], 1, 0, 0, 0, 1);
            case "TRANSL2D" -> BigMatrix.of(3, 1, 0, 0, 0, 1, 0, p[0], p[1], 1);
            case "IDENTITY" -> BigMatrix.identity(4);
            case "ROT3DX", "ROT3DY", "ROT3DZ" -> turn(name.charAt(5), turn(p[0]));
            case "SCALE3DX" -> diagonal(p[0], 1, 1, 1);
            case "SCALE3DY" -> diagonal(1, p[0], 1, 1);
            case "SCALE3DZ" -> diagonal(1, 1, p[0], 1);
            case "SCALE3D" -> diagonal(1, 1, 1, p[0]);
            case "REFL3DXY" -> diagonal(1, 1, -1, 1);
            case "REFL3DYZ" -> diagonal(-1, 1, 1, 1);
            case "REFL3DZX" -> diagonal(1, -1, 1, 1);
            case "TRANSL3D" -> shift(p[0], p[1], p[2]);
            case "ROTAXIS" -> aboutAxis(p);
            case "HERMITE" -> hermite();
            case "HERMITE_BEZIER" -> endsAndTangents();
            case "BEZIER" -> hermite().then(endsAndTangents());
            default -> ExactViews.of(name, p);
        };
    }

    static BigTrig turn(double degrees) {
        return BigTrig.ofDegrees(degrees);
    }

    static BigMatrix diagonal(Object a, Object e, Object j, Object s) {
        return BigMatrix.of(4, a, 0, 0, 0, 0, e, 0, 0, 0, 0, j, 0, 0, 0, 0, s);
    }

    static BigMatrix shift(Object l, Object m, Object n) {
        return BigMatrix.of(4, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, l, m, n, 1);
    }

    static BigMatrix turn(char axis, BigTrig by) {
        return turn(axis, by.sin(), by.cos());
    }

    /** The axis after the turning one goes to the one after that. */
    static BigMatrix turn(char axis, BigDecimal sin, BigDecimal cos) {
        BigMatrix turn = BigMatrix.identity(4);
        int first = (axis - 'X' + 1) % 3;
        int second = (axis - 'X' + 2) % 3;
        turn.rows()[first][first] = cos;
        turn.rows()[second][second] = cos;
        turn.rows()[first][second] = sin;
        turn.rows()[second][first] = sin.negate();
        return turn;
    }

    private static BigMatrix plane(BigTrig by) {
        BigDecimal s = by.sin();
        BigDecimal c = by.cos();
        return BigMatrix.of(3, c, s, 0, s.negate(), c, 0, 0, 0, 1);
    }

    private static BigMatrix aboutAxis(double[] p) {
        var axis =
                new BigAxis(new double[] {p[0], p[1], p[2]}, new double[] {p[3], p[4], p[5]}, p[6]);
        BigMatrix matrix = BigMatrix.identity(4);
        // This is the same rotation about the origin: beside a far axis its entries would lose all
        // digits.
        var near = new BigAxis(new double[3], new double[] {p[3], p[4], p[5]}, p[6]);
        BigDecimal zero = BigDecimal.ZERO;
        BigDecimal[] origin = axis.image(new BigDecimal[] {zero, zero, zero});
        for (int i = 0; i < 3; i++) {
            BigDecimal[] end = near.image(Arrays.copyOf(matrix.rows()[i], 3));
            for (int j = 0; j < 3; j++) matrix.rows()[i][j] = end[j].round(DIGITS);
            matrix.rows()[3][i] = origin[i];
        }
        return matrix;
    }

    /** Rows t³, t², t, 1: x(0) = P1, x(1) = P4, x'(0) = R1, x'(1) = R4. */
    private static BigMatrix hermite() {
        return BigMatrix.of(4, 2, -2, 1, 1, -3, 3, -2, -1, 0, 0, 1, 0, 1, 0, 0, 0);
    }

    /** R1 = 3·(P2 − P1), R4 = 3·(P4 − P3). */
    private static BigMatrix endsAndTangents() {
        return BigMatrix.of(4, 1, 0, 0, 0, 0, 0, 0, 1, -3, 3, 0, 0, 0, 0, -3, 3);
    }
}
