package rasterlab.engine.transform.view;

import rasterlab.contract.EyeView;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Coordinates;
import rasterlab.engine.transform.CountingArithmetic;

/** A view that looks at its arguments first, with a twin that counts its work. */
abstract class CheckedView implements EyeView {
    @Override
    public final void view(double theta, double phi, double rho, double[] points) {
        require(rho, points);
        view(Angle.ofDegrees(theta), Angle.ofDegrees(phi), rho, points);
    }

    final void count(CountingArithmetic on, double theta, double phi, double rho, double[] points) {
        require(rho, points);
        count(on, Angle.ofDegrees(theta), Angle.ofDegrees(phi), rho, points);
    }

    static void require(double rho, double[] points) {
        if (!(rho > 0 && rho <= Coordinates.LARGEST))
            throw new IllegalArgumentException(
                    "rho must be above 0, up to " + Coordinates.LARGEST + ", got " + rho);
        Coordinates.require(points, 3, Coordinates.LARGEST);
    }

    abstract void view(Angle theta, Angle phi, double rho, double[] points);

    /** Transforms the points operation by operation, each of them counted. */
    abstract void count(CountingArithmetic on, Angle theta, Angle phi, double rho, double[] points);
}
