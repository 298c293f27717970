package rasterlab.engine.transform.view;

import rasterlab.contract.EyeView;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;
import rasterlab.engine.transform.Coordinates;

/** A view whose work can be counted. */
abstract class CountedView implements EyeView {
    @Override
    public final void view(double theta, double phi, double rho, double[] points) {
        view(Arithmetic.PLAIN, theta, phi, rho, points);
    }

    final void view(Arithmetic on, double theta, double phi, double rho, double[] points) {
        if (!(rho > 0 && rho <= Coordinates.LARGEST))
            throw new IllegalArgumentException(
                    "rho must be above 0, up to " + Coordinates.LARGEST + ", got " + rho);
        Coordinates.require(points, 3, Coordinates.LARGEST);
        view(on, Angle.ofDegrees(theta), Angle.ofDegrees(phi), rho, points);
    }

    abstract void view(Arithmetic on, Angle theta, Angle phi, double rho, double[] points);
}
