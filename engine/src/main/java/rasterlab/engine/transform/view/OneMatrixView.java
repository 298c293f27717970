package rasterlab.engine.transform.view;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.CountingArithmetic;

/**
 * VP_L made once, its cells that are not 0 or 1 applied to every point: 4 multiplications for the
 * matrix, 8 and 6 additions for a point. For a single point that is 12 and 6.
 *
 * <p>The course counts 12 and 5, 17 in all: it leaves out the addition of ρ, which it does count
 * where the view is taken apart.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "view
 * transformation".
 */
final class OneMatrixView extends CheckedView {
    @Override
    void view(Angle theta, Angle phi, double rho, double[] points) {
        double xy = -theta.cos() * phi.cos();
        double xz = -theta.cos() * phi.sin();
        double yy = -theta.sin() * phi.cos();
        double yz = -theta.sin() * phi.sin();
        for (int at = 0; at < points.length; at += 3) {
            double x = points[at];
            double y = points[at + 1];
            double z = points[at + 2];
            points[at] = y * theta.cos() - x * theta.sin();
            points[at + 1] = x * xy + y * yy + z * phi.sin();
            points[at + 2] = rho + (x * xz + y * yz - z * phi.cos());
        }
    }

    @Override
    void count(CountingArithmetic on, Angle theta, Angle phi, double rho, double[] points) {
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
