package rasterlab.engine.transform.view;

import java.math.BigDecimal;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.exact.BigTrig;

/** The right places: along the three directions right, up and forward of the eye, to 60 digits. */
final class ExactView {
    private ExactView() {}

    static Images images(ViewTask look, int limit) {
        BigTrig theta = BigTrig.ofDegrees(look.theta());
        BigTrig phi = BigTrig.ofDegrees(look.phi());
        BigDecimal zero = BigDecimal.ZERO;
        BigDecimal[] right = {theta.sin().negate(), theta.cos(), zero};
        BigDecimal[] back = {
            theta.cos().multiply(phi.sin()), theta.sin().multiply(phi.sin()), phi.cos()
        };
        BigDecimal[] up = {
            theta.cos().multiply(phi.cos()).negate(),
            theta.sin().multiply(phi.cos()).negate(),
            phi.sin()
        };
        double[] p = new Images(look.points(), 3).first(limit).coordinates();
        var images = new double[p.length];
        for (int at = 0; at < p.length; at += 3) {
            images[at] = dot(right, p, at).doubleValue();
            images[at + 1] = dot(up, p, at).doubleValue();
            images[at + 2] = new BigDecimal(look.rho()).subtract(dot(back, p, at)).doubleValue();
        }
        return new Images(images, 3);
    }

    private static BigDecimal dot(BigDecimal[] direction, double[] p, int at) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < 3; i++) sum = sum.add(direction[i].multiply(new BigDecimal(p[at + i])));
        return sum;
    }
}
