package rasterlab.engine.transform.view;

import java.util.List;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.CountingArithmetic;

/**
 * The six steps as the course prints them: step 2 finds yy, which steps 5 and 6 should take and do
 * not.
 *
 * <p>Step 5 takes the world's y where yy is meant, and step 6 takes the y that step 5 has just
 * overwritten.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "view
 * transformation".
 */
final class DecomposedTextbookView extends CheckedView implements SteppedView {
    @Override
    void view(Angle theta, Angle phi, double rho, double[] points) {
        for (int at = 0; at < points.length; at += 3) {
            double x = points[at];
            double y = points[at + 1];
            double z = points[at + 2];
            points[at] = y * theta.cos() - x * theta.sin();
            y = z * phi.sin() - y * phi.cos();
            points[at + 1] = y;
            points[at + 2] = rho - y * phi.sin() - z * phi.cos();
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
        double overwritten = z * p.sin() - y * p.cos();
        return List.of(
                new ViewStep(1, "xx = y·cos θ − x·sin θ", xx),
                new ViewStep(2, "yy = x·cos θ + y·sin θ", yy),
                new ViewStep(3, "zz = z", z),
                new ViewStep(4, "x = xx", xx),
                new ViewStep(5, "y = z·sin φ − y·cos φ", overwritten),
                new ViewStep(
                        6, "z = ρ − y·sin φ − z·cos φ", rho - overwritten * p.sin() - z * p.cos()));
    }

    @Override
    void count(CountingArithmetic on, Angle theta, Angle phi, double rho, double[] points) {
        for (int at = 0; at < points.length; at += 3) {
            double x = points[at];
            double y = points[at + 1];
            double z = points[at + 2];
            points[at] = on.minus(on.times(y, theta.cos()), on.times(x, theta.sin()));
            on.plus(on.times(x, theta.cos()), on.times(y, theta.sin()));
            y = on.minus(on.times(z, phi.sin()), on.times(y, phi.cos()));
            points[at + 1] = y;
            points[at + 2] =
                    on.minus(on.minus(rho, on.times(y, phi.sin())), on.times(z, phi.cos()));
        }
    }
}
