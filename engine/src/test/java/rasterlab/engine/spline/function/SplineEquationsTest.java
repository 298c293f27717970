package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.SplineEnds;

/** Chapter 8's count: m pieces have 4·m unknowns, the knots 4·m − 2 equations, two are left. */
class SplineEquationsTest {
    private static final double[] X = {0, 1, 2.5, 3, 5, 6};
    private static final double[] Y = {1, 3, -2, 0.5, 4, 1};

    /** Factors of the 4·m coefficients and, at the end, what their sum is. */
    private static List<double[]> equations(int m) {
        var equations = new ArrayList<double[]>();
        for (int i = 0; i < m; i++) {
            double h = X[i + 1] - X[i];
            equations.add(equation(m, Y[i], i, 1, 0, 0, 0));
            equations.add(equation(m, Y[i + 1], i, 1, h, h * h, h * h * h));
            if (i == m - 1) continue;
            double[] slope = equation(m, 0, i, 0, 1, 2 * h, 3 * h * h);
            slope[4 * (i + 1) + 1] = -1;
            equations.add(slope);
            double[] bend = equation(m, 0, i, 0, 0, 2, 6 * h);
            bend[4 * (i + 1) + 2] = -2;
            equations.add(bend);
        }
        return equations;
    }

    private static double[] equation(int m, double right, int piece, double... factors) {
        var equation = new double[4 * m + 1];
        System.arraycopy(factors, 0, equation, 4 * piece, 4);
        equation[4 * m] = right;
        return equation;
    }

    @ParameterizedTest(name = "{0} pieces have an equation too many")
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void chapter8TwoOfFourMUnknownsAreLeft(int m) {
        assertEquals(4 * m - 2, equations(m).size());
        assertEquals(4 * m - 2, rank(equations(m), 4 * m));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("ends")
    void chapter8TheSplineKeepsAllOfThem(SplineEnds ends) {
        int m = X.length - 1;
        double[] coefficients = new CubicSpline().coefficients(X, Y, ends);
        for (double[] equation : equations(m)) {
            double sum = 0;
            for (int i = 0; i < 4 * m; i++) sum += equation[i] * coefficients[i];
            assertEquals(equation[4 * m], sum, 1e-12);
        }
    }

    static Stream<Arguments> ends() {
        return Stream.of(
                argumentSet("slopes break the curve", SplineEnds.slopes(2, -1)),
                argumentSet("natural ends break the curve", SplineEnds.natural()),
                argumentSet("not-a-knot ends break the curve", SplineEnds.notAKnot()),
                argumentSet("a period breaks the curve", SplineEnds.periodic()));
    }

    /** The rank, by elimination with the largest pivot. */
    private static int rank(List<double[]> rows, int columns) {
        int rank = 0;
        for (int column = 0; column < columns && rank < rows.size(); column++) {
            int best = rank;
            for (int i = rank; i < rows.size(); i++)
                if (Math.abs(rows.get(i)[column]) > Math.abs(rows.get(best)[column])) best = i;
            double[] pivot = rows.get(best);
            if (Math.abs(pivot[column]) < 1e-9) continue;
            rows.set(best, rows.get(rank));
            rows.set(rank, pivot);
            rank++;
            for (int i = rank; i < rows.size(); i++) {
                double factor = rows.get(i)[column] / pivot[column];
                for (int j = column; j < columns; j++) rows.get(i)[j] -= factor * pivot[j];
            }
        }
        return rank;
    }
}
