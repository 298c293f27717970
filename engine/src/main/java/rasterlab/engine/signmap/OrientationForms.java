package rasterlab.engine.signmap;

import java.math.BigDecimal;
import java.util.List;
import rasterlab.engine.geometry.Orientation;
import rasterlab.engine.predicate.Spacing;

/**
 * The orientation of p, q = (12, 12) and r = (24, 24), p being near (½, ½): 1 where they turn
 * counter-clockwise, 0 where they lie on one line.
 *
 * <p>In exact numbers it does not matter which point is subtracted from the others; in doubles it
 * does. Source: L. Kettner, K. Mehlhorn, S. Pion, S. Schirra, C. Yap, Classroom examples of
 * robustness problems in geometric computations, Computational Geometry 40(1), 2008, pp. 61–78,
 * whose first example this is.
 */
final class OrientationForms {
    private static final double Q = 12;
    private static final double R = 24;
    private static final BigDecimal EXACT_Q = new BigDecimal(Q);
    private static final BigDecimal EXACT_R = new BigDecimal(R);

    private OrientationForms() {}

    static SignSubject subject() {
        return new FormSigns(
                "orientation",
                "q = (12, 12), r = (24, 24)",
                List.of(
                        new SignForm("from-p", Spacing.DOUBLE, OrientationForms::fromP),
                        new SignForm("from-q", Spacing.DOUBLE, OrientationForms::fromQ),
                        new SignForm("from-r", Spacing.DOUBLE, OrientationForms::fromR),
                        new SignForm("float", Spacing.FLOAT, OrientationForms::inFloat),
                        new SignForm(
                                "robust",
                                Spacing.DOUBLE,
                                (x, y) -> Orientation.of(x, y, Q, Q, R, R))),
                OrientationForms::exact);
    }

    private static int fromP(double x, double y) {
        return sign((Q - x) * (R - y) - (Q - y) * (R - x));
    }

    private static int fromQ(double x, double y) {
        return sign((R - Q) * (y - Q) - (R - Q) * (x - Q));
    }

    private static int fromR(double x, double y) {
        return sign((x - R) * (Q - R) - (y - R) * (Q - R));
    }

    private static int inFloat(double x, double y) {
        float px = (float) x;
        float py = (float) y;
        float q = (float) Q;
        float r = (float) R;
        return sign((q - px) * (r - py) - (q - py) * (r - px));
    }

    private static int exact(double x, double y) {
        var px = new BigDecimal(x);
        var py = new BigDecimal(y);
        BigDecimal left = EXACT_Q.subtract(px).multiply(EXACT_R.subtract(py));
        return left.compareTo(EXACT_Q.subtract(py).multiply(EXACT_R.subtract(px)));
    }

    static int sign(double value) {
        return (int) Math.signum(value);
    }
}
