package rasterlab.engine.spline.function;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import rasterlab.contract.SplineEnds;

/**
 * The cubic spline, computed to {@value #DIGITS} digits, slow and plain.
 *
 * <p>The unknowns are the second derivatives M at the knots, the equations {@code h[i−1]·M[i−1] +
 * 2·(h[i−1] + h[i])·M[i] + h[i]·M[i+1] = 6·(δ[i] − δ[i−1])} and those of the ends, each kept as a
 * list of its numbers that are not 0 and eliminated in order. Widths and values are exact, and so
 * many digits leave enough where neighbouring widths differ by a factor of 10³⁰.
 */
final class ExactSpline {
    private static final int DIGITS = 100;
    private static final MathContext PRECISE = new MathContext(DIGITS);

    /** A value has these before it becomes a double: of more that is slow. */
    private static final MathContext FOR_DOUBLE = new MathContext(25);

    private static final int VALUE = Integer.MAX_VALUE;

    private final SplineProblem problem;
    private final int pieces;
    private final BigDecimal[] width;
    private final BigDecimal[] secant;
    private final BigDecimal[] curvature;

    /** Coefficients of s, s² and s³ of each piece. */
    private final BigDecimal[] linear;

    private final BigDecimal[] quadratic;
    private final BigDecimal[] cubic;

    /**
     * @param problem its knots increase and all its numbers are finite
     */
    ExactSpline(SplineProblem problem) {
        this.problem = problem;
        pieces = problem.x().length - 1;
        width = new BigDecimal[pieces];
        secant = new BigDecimal[pieces];
        for (int i = 0; i < pieces; i++) {
            width[i] = x(i + 1).subtract(x(i));
            secant[i] = y(i + 1).subtract(y(i)).divide(width[i], PRECISE);
        }
        curvature = solved(rows());
        linear = new BigDecimal[pieces];
        quadratic = new BigDecimal[pieces];
        cubic = new BigDecimal[pieces];
        for (int i = 0; i < pieces; i++) {
            BigDecimal sum = curvature[i].multiply(number(2)).add(curvature[i + 1]);
            linear[i] = secant[i].subtract(width[i].multiply(sum).divide(number(6), PRECISE));
            quadratic[i] = curvature[i].divide(number(2), PRECISE);
            BigDecimal change = curvature[i + 1].subtract(curvature[i]);
            cubic[i] = change.divide(width[i].multiply(number(6)), PRECISE);
        }
    }

    /** The values at all places of the problem. */
    double[] values() {
        var values = new double[problem.at().length];
        for (int i = 0; i < values.length; i++) values[i] = value(problem.at()[i]);
        return values;
    }

    private double value(double place) {
        boolean folds = problem.folds(place);
        BigDecimal at = folds ? problem.folded(place) : new BigDecimal(place);
        int i = problem.piece(folds ? at.doubleValue() : place);
        BigDecimal s = at.subtract(x(i));
        BigDecimal rise = quadratic[i].add(s.multiply(cubic[i]), PRECISE);
        return y(i).add(s.multiply(linear[i].add(s.multiply(rise), PRECISE)), FOR_DOUBLE)
                .doubleValue();
    }

    private List<TreeMap<Integer, BigDecimal>> rows() {
        boolean periodic = problem.ends().kind() == SplineEnds.Kind.PERIODIC;
        var rows = new ArrayList<TreeMap<Integer, BigDecimal>>();
        for (int i = periodic ? 0 : 1; i < pieces; i++) {
            int before = (i + pieces - 1) % pieces;
            var row = new TreeMap<Integer, BigDecimal>();
            add(row, periodic ? before : i - 1, width[before]);
            add(row, i, width[before].add(width[i]).multiply(number(2)));
            add(row, periodic ? (i + 1) % pieces : i + 1, width[i]);
            add(row, VALUE, secant[i].subtract(secant[before]).multiply(number(6)));
            rows.add(row);
        }
        if (!periodic) {
            rows.add(0, end(problem.ends().left(), 0, 0, 1));
            rows.add(end(problem.ends().right(), pieces, pieces - 1, -1));
        }
        return rows;
    }

    private TreeMap<Integer, BigDecimal> end(double slope, int knot, int piece, int inward) {
        var row = new TreeMap<Integer, BigDecimal>();
        if (problem.ends().kind() == SplineEnds.Kind.SLOPES) {
            BigDecimal bend = secant[piece].subtract(new BigDecimal(slope));
            add(row, knot, width[piece].multiply(number(2)));
            add(row, knot + inward, width[piece]);
            add(row, VALUE, bend.multiply(number(6 * inward)));
        } else if (problem.ends().kind() == SplineEnds.Kind.NATURAL || pieces == 1) {
            add(row, knot, BigDecimal.ONE);
        } else if (pieces == 2) {
            add(row, knot, BigDecimal.ONE);
            add(row, knot + inward, BigDecimal.ONE.negate());
        } else {
            BigDecimal outer = width[piece];
            BigDecimal inner = width[piece + inward];
            add(row, knot, inner);
            add(row, knot + inward, outer.add(inner).negate());
            add(row, knot + 2 * inward, outer);
        }
        return row;
    }

    private static void add(TreeMap<Integer, BigDecimal> row, int column, BigDecimal number) {
        row.merge(column, number, (a, b) -> a.add(b, PRECISE));
    }

    private BigDecimal[] solved(List<TreeMap<Integer, BigDecimal>> rows) {
        for (int r = 0; r < rows.size(); r++) {
            TreeMap<Integer, BigDecimal> row = rows.get(r);
            while (row.firstKey() < r) eliminate(row, row.firstKey(), rows);
        }
        var found = new BigDecimal[pieces + 1];
        for (int r = rows.size() - 1; r >= 0; r--) {
            TreeMap<Integer, BigDecimal> row = rows.get(r);
            BigDecimal rest = row.getOrDefault(VALUE, BigDecimal.ZERO);
            for (int column : row.subMap(r + 1, VALUE).keySet())
                rest = rest.subtract(row.get(column).multiply(found[column]), PRECISE);
            found[r] = rest.divide(row.get(r), PRECISE);
        }
        if (found[pieces] == null) found[pieces] = found[0];
        return found;
    }

    private static void eliminate(
            TreeMap<Integer, BigDecimal> row, int column, List<TreeMap<Integer, BigDecimal>> rows) {
        TreeMap<Integer, BigDecimal> pivot = rows.get(column);
        BigDecimal factor = row.get(column).divide(pivot.get(column), PRECISE).negate();
        pivot.forEach((key, number) -> add(row, key, number.multiply(factor, PRECISE)));
        row.remove(column);
    }

    private BigDecimal x(int i) {
        return new BigDecimal(problem.x()[i]);
    }

    private BigDecimal y(int i) {
        return new BigDecimal(problem.y()[i]);
    }

    private static BigDecimal number(int n) {
        return BigDecimal.valueOf(n);
    }
}
