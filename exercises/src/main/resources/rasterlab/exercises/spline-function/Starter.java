import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;

/** Finds the cubic spline through points. So far all its coefficients are 0. */
public class MySpline implements SplineFunction {
    @Override
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        return new double[4 * (x.length - 1)];
    }
}
