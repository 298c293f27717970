package rasterlab.engine.transform.matrix;

import static rasterlab.engine.transform.exact.BigTrig.DIGITS;
import static rasterlab.engine.transform.matrix.ExactMatrices.diagonal;
import static rasterlab.engine.transform.matrix.ExactMatrices.shift;
import static rasterlab.engine.transform.matrix.ExactViews.big;
import static rasterlab.engine.transform.matrix.ExactViews.ratio;

import java.math.BigDecimal;
import rasterlab.engine.transform.exact.BigMatrix;
import rasterlab.engine.transform.exact.BigTrig;

/** OpenGL's matrices to 60 digits: the box moved to the origin and stretched to −1..1. */
final class ExactGl {
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    private ExactGl() {}

    static BigMatrix of(String name, double... p) {
        return switch (name) {
            case "GL_ORTHO" -> box(big(p[0]), big(p[1]), big(p[2]), big(p[3]), p[4], p[5]);
            case "GL_FRUSTUM" -> frustum(big(p[0]), big(p[1]), big(p[2]), big(p[3]), p[4], p[5]);
            case "GL_PERSPECTIVE" -> perspective(p);
            case "VIEWPORT" ->
                    diagonal(half(p[2]), half(p[3]), half(p[5]).subtract(half(p[4])), 1)
                            .then(
                                    shift(
                                            half(p[2]).add(big(p[0])),
                                            half(p[3]).add(big(p[1])),
                                            half(p[4]).add(half(p[5]))));
            case "LOOKAT" -> lookAt(p);
            default -> throw new IllegalArgumentException("no exact matrix '" + name + "'");
        };
    }

    private static BigDecimal half(double value) {
        return big(value).divide(TWO);
    }

    private static BigMatrix box(
            BigDecimal left,
            BigDecimal right,
            BigDecimal bottom,
            BigDecimal top,
            double near,
            double far) {
        BigDecimal n = big(near);
        BigDecimal f = big(far);
        return shift(
                        left.add(right).divide(TWO).negate(),
                        bottom.add(top).divide(TWO).negate(),
                        n.add(f).divide(TWO))
                .then(
                        diagonal(
                                ratio(TWO, right.subtract(left)),
                                ratio(TWO, top.subtract(bottom)),
                                ratio(TWO, n.subtract(f)),
                                1));
    }

    /** The pyramid bent to a box (x·n, y·n, z·(n + f) + n·f over −z) and then the box. */
    private static BigMatrix frustum(
            BigDecimal left,
            BigDecimal right,
            BigDecimal bottom,
            BigDecimal top,
            double near,
            double far) {
        BigDecimal n = big(near);
        BigDecimal both = n.add(big(far));
        BigDecimal product = n.multiply(big(far));
        return BigMatrix.of(4, n, 0, 0, 0, 0, n, 0, 0, 0, 0, both, -1, 0, 0, product, 0)
                .then(box(left, right, bottom, top, near, far));
    }

    private static BigMatrix perspective(double[] p) {
        BigTrig halfAngle = BigTrig.ofDegrees(half(p[0]));
        BigDecimal top = big(p[2]).multiply(ratio(halfAngle.sin(), halfAngle.cos()));
        BigDecimal right = top.multiply(big(p[1]));
        return frustum(right.negate(), right, top.negate(), top, p[2], p[3]);
    }

    private static BigMatrix lookAt(double[] p) {
        var back = new BigDecimal[3];
        var up = new BigDecimal[3];
        for (int i = 0; i < 3; i++) {
            back[i] = big(p[i]).subtract(big(p[3 + i]));
            up[i] = big(p[6 + i]);
        }
        back = unit(back);
        BigDecimal[] side = unit(cross(up, back));
        BigDecimal[] top = cross(back, side);
        BigMatrix turn = BigMatrix.identity(4);
        for (int i = 0; i < 3; i++) {
            turn.rows()[i][0] = side[i];
            turn.rows()[i][1] = top[i];
            turn.rows()[i][2] = back[i];
        }
        return shift(-p[0], -p[1], -p[2]).then(turn);
    }

    private static BigDecimal[] cross(BigDecimal[] a, BigDecimal[] b) {
        var cross = new BigDecimal[3];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            cross[i] = a[j].multiply(b[k]).subtract(a[k].multiply(b[j]));
        }
        return cross;
    }

    private static BigDecimal[] unit(BigDecimal[] v) {
        BigDecimal square = BigDecimal.ZERO;
        for (BigDecimal part : v) square = square.add(part.multiply(part));
        BigDecimal length = square.sqrt(DIGITS);
        var unit = new BigDecimal[3];
        for (int i = 0; i < 3; i++) unit[i] = v[i].divide(length, DIGITS);
        return unit;
    }
}
