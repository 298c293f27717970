package rasterlab.engine.transform.view;

import java.util.List;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.CountingArithmetic;

/**
 * The turn about z first, then the turn about x and the shift: 8 multiplications and 5 additions
 * per point, 13 in all, and nothing to prepare.
 *
 * <p>The text numbers six steps; its 5 and 6 are printed with y and z where yy and zz are meant, so
 * that 6 would take the y that 5 has just overwritten.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "view
 * transformation".
 */
final class DecomposedView extends CheckedView implements SteppedView {
    @Override
    void view(Angle theta, Angle phi, double rho, double[] points) {
        for (int at = 0; at < points.length; at += 3) {
            double x = points[at];
            double y = points[at + 1];
            double z = points[at + 2];
            double along = x * theta.cos() + y * theta.sin();
            points[at] = y * theta.cos() - x * theta.sin();
            points[at + 1] = z * phi.sin() - along * phi.cos();
            points[at + 2] = rho - along * phi.sin() - z * phi.cos();
        }
    }

    @Override
    public List<ViewStep> steps(
            double theta, double phi, double rho, double x, double y, double z) {
        require(rho, new double[] {x, y, z});
        Angle t = Angle.ofDegrees(theta);
        Angle p = Angle.ofDegrees(phi);
        double xx = y * t.cos() - x * t.sin();
        double yy = x * t.cos() + y * t.sin();
        double zz = z;
        return List.of(
                new ViewStep(1, "xx = y·cos θ − x·sin θ", xx),
                new ViewStep(2, "yy = x·cos θ + y·sin θ", yy),
                new ViewStep(3, "zz = z", zz),
                new ViewStep(4, "x = xx", xx),
                new ViewStep(5, "y = zz·sin φ − yy·cos φ", zz * p.sin() - yy * p.cos()),
                new ViewStep(6, "z = ρ − yy·sin φ − zz·cos φ", rho - yy * p.sin() - zz * p.cos()));
    }

    @Override
    void count(CountingArithmetic on, Angle theta, Angle phi, double rho, double[] points) {
        for (int at = 0; at < points.length; at += 3) {
            double x = points[at];
            double y = points[at + 1];
            double z = points[at + 2];
            double along = on.plus(on.times(x, theta.cos()), on.times(y, theta.sin()));
            points[at] = on.minus(on.times(y, theta.cos()), on.times(x, theta.sin()));
            points[at + 1] = on.minus(on.times(z, phi.sin()), on.times(along, phi.cos()));
            points[at + 2] =
                    on.minus(on.minus(rho, on.times(along, phi.sin())), on.times(z, phi.cos()));
        }
    }
}
