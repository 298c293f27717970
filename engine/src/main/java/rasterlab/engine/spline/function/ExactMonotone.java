package rasterlab.engine.spline.function;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.SplineEnds;

/**
 * The monotone cubic of Fritsch and Carlson, computed to {@value #DIGITS} digits, slow and plain.
 */
final class ExactMonotone {
    private static final int DIGITS = 60;
    private static final MathContext PRECISE = new MathContext(DIGITS);

    /** A value has these before it becomes a double: of more that is slow. */
    private static final MathContext FOR_DOUBLE = new MathContext(25);

    private static final BigDecimal TWO = BigDecimal.valueOf(2);
    private static final BigDecimal THREE = BigDecimal.valueOf(3);

    private final SplineProblem problem;
    private final SplineEnds.Kind kind;
    private final int last;
    private final BigDecimal[] x;
    private final BigDecimal[] y;
    private final BigDecimal[] slope;

    /**
     * @param problem its knots increase and all its numbers are finite
     */
    ExactMonotone(SplineProblem problem) {
        this.problem = problem;
        kind = problem.ends().kind();
        last = problem.x().length - 1;
        x = decimals(problem.x());
        y = decimals(problem.y());
        slope = new BigDecimal[last + 1];
        for (int i = 1; i < last; i++)
            slope[i] = inner(secant(i - 1), secant(i), width(i - 1), width(i));
        BigDecimal left = end(problem.ends().left(), 0, 1);
        BigDecimal right = end(problem.ends().right(), last, last - 1);
        slope[0] = left;
        slope[last] = right;
        for (int i = 0; i < last; i++) pullBack(i);
        if (kind == SplineEnds.Kind.PERIODIC) {
            slope[0] = slope[0].abs().min(slope[last].abs()).multiply(sign(slope[0]));
            slope[last] = slope[0];
        }
    }

    double[] values() {
        var values = new double[problem.at().length];
        for (int i = 0; i < values.length; i++)
            values[i] = value(problem.at()[i]).round(FOR_DOUBLE).doubleValue();
        return values;
    }

    /** The four Hermite functions, each times what it blends. */
    private BigDecimal value(double place) {
        boolean folds = problem.folds(place);
        BigDecimal at = folds ? problem.folded(place) : new BigDecimal(place);
        int i = problem.piece(folds ? at.doubleValue() : place);
        BigDecimal h = width(i);
        BigDecimal t = at.subtract(x[i]).divide(h, PRECISE);
        BigDecimal u = BigDecimal.ONE.subtract(t);
        BigDecimal first = u.multiply(u).multiply(t.multiply(TWO).add(BigDecimal.ONE));
        BigDecimal second = t.multiply(t).multiply(u.multiply(TWO).add(BigDecimal.ONE));
        return y[i].multiply(first)
                .add(y[i + 1].multiply(second))
                .add(slope[i].multiply(h).multiply(t.multiply(u).multiply(u)))
                .subtract(slope[i + 1].multiply(h).multiply(t.multiply(t).multiply(u)));
    }

    private BigDecimal end(double given, int knot, int neighbour) {
        int piece = Math.min(knot, neighbour);
        BigDecimal secant = secant(piece);
        BigDecimal wanted;
        if (kind == SplineEnds.Kind.PERIODIC)
            return inner(secant(last - 1), secant(0), width(last - 1), width(0));
        if (kind == SplineEnds.Kind.SLOPES) wanted = new BigDecimal(given);
        else if (last == 1) wanted = secant;
        else if (kind == SplineEnds.Kind.NATURAL)
            wanted = secant.multiply(THREE).subtract(slope[neighbour]).divide(TWO);
        else {
            int next = knot == 0 ? 1 : last - 2;
            BigDecimal both = width(piece).add(width(next));
            BigDecimal bend = secant.subtract(secant(next)).divide(both, PRECISE);
            wanted = secant.add(bend.multiply(width(piece)));
        }
        return wanted.signum() == secant.signum() ? wanted : BigDecimal.ZERO;
    }

    private static BigDecimal inner(
            BigDecimal before, BigDecimal after, BigDecimal wide, BigDecimal next) {
        if (before.signum() != after.signum()) return BigDecimal.ZERO;
        return before.multiply(next).add(after.multiply(wide)).divide(wide.add(next), PRECISE);
    }

    private void pullBack(int i) {
        BigDecimal secant = secant(i);
        BigDecimal square =
                slope[i].multiply(slope[i]).add(slope[i + 1].multiply(slope[i + 1]), PRECISE);
        BigDecimal reach = secant.multiply(THREE).abs();
        if (square.compareTo(reach.multiply(reach)) <= 0) return;
        BigDecimal back = reach.divide(square.sqrt(PRECISE), PRECISE);
        slope[i] = slope[i].multiply(back, PRECISE);
        slope[i + 1] = slope[i + 1].multiply(back, PRECISE);
    }

    private BigDecimal width(int i) {
        return x[i + 1].subtract(x[i]);
    }

    private BigDecimal secant(int i) {
        return y[i + 1].subtract(y[i]).divide(width(i), PRECISE);
    }

    private static BigDecimal sign(BigDecimal number) {
        return BigDecimal.valueOf(number.signum());
    }

    private static BigDecimal[] decimals(double[] numbers) {
        var decimals = new BigDecimal[numbers.length];
        for (int i = 0; i < numbers.length; i++) decimals[i] = new BigDecimal(numbers[i]);
        return decimals;
    }
}
