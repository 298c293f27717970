package rasterlab.engine.study.measuring;

import java.util.List;
import java.util.Optional;

/**
 * The power p in y ≈ c·xᵖ, by least squares on the logarithms, with the interval in which it lies
 * in 95 of 100 fits, should the logarithms scatter normally about the line.
 *
 * <p>Source: N. Draper and H. Smith, Applied Regression Analysis, 3rd edition, Wiley 1998, section
 * 1.4; t by G. W. Hill, Algorithm 396, Communications of the ACM 13(10), 1970, pp. 619–620.
 *
 * @param exponent p
 * @param margin the interval is p ± margin
 * @param factor c
 */
public record PowerFit(double exponent, double margin, double factor) {
    /** Student's t at 97.5 % for 1, 2, … degrees of freedom, then the normal one. */
    private static final double[] T = {
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228
    };

    private static final double NORMAL = 1.96;

    /** A point of the curve. */
    public record FittedPoint(double x, double y) {}

    /** The fit; empty below three different points above 0, which tell no interval. */
    public static Optional<PowerFit> of(List<FittedPoint> points) {
        List<FittedPoint> logs =
                points.stream()
                        .filter(one -> one.x > 0 && one.y > 0 && Double.isFinite(one.y))
                        .map(one -> new FittedPoint(Math.log(one.x), Math.log(one.y)))
                        .toList();
        int n = logs.size();
        if (logs.stream().mapToDouble(FittedPoint::x).distinct().count() < 3)
            return Optional.empty();
        double x = logs.stream().mapToDouble(FittedPoint::x).average().orElseThrow();
        double y = logs.stream().mapToDouble(FittedPoint::y).average().orElseThrow();
        double xx = logs.stream().mapToDouble(one -> (one.x - x) * (one.x - x)).sum();
        double xy = logs.stream().mapToDouble(one -> (one.x - x) * (one.y - y)).sum();
        double slope = xy / xx;
        double rest =
                logs.stream()
                        .mapToDouble(one -> Math.pow(one.y - y - slope * (one.x - x), 2))
                        .sum();
        double t = n - 3 < T.length ? T[n - 3] : NORMAL;
        double margin = t * Math.sqrt(rest / (n - 2) / xx);
        return Optional.of(new PowerFit(slope, margin, Math.exp(y - slope * x)));
    }
}
