package rasterlab.engine.transform.view;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;

/**
 * VP_L made once, its cells that are not 0 or 1 applied to every point: 4 multiplications for the
 * matrix, 8 and 6 additions for a point. For a single point that is 12 and 6.
 *
 * <p>The course counts 12 and 5, 17 in all: it leaves out the addition of ρ, which it does count
 * where the view is taken apart.
 *
 * <p>Source: Ponomarev, course text on computer graphics, "view transformation".
 */
final class OneMatrixView extends CountedView {
    @Override
    void view(Arithmetic on, Angle theta, Angle phi, double rho, double[] points) {
        double xy = on.times(-theta.cos(), phi.cos());
        double xz = on.times(-theta.cos(), phi.sin());
        double yy = on.times(-theta.sin(), phi.cos());
        double yz = on.times(-theta.sin(), phi.sin());
        for (int at = 0; at < points.length; at += 3) {
            double x = points[at];
            double y = points[at + 1];
            double z = points[at + 2];
            points[at] = on.minus(on.times(y, theta.cos()), on.times(x, theta.sin()));
            points[at + 1] =
                    on.plus(on.plus(on.times(x, xy), on.times(y, yy)), on.times(z, phi.sin()));
            double depth =
                    on.minus(on.plus(on.times(x, xz), on.times(y, yz)), on.times(z, phi.cos()));
            points[at + 2] = on.plus(rho, depth);
        }
    }
}
