import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;

public class Slopes implements SplineFunction {
    record Row(double before, double own, double after, double value) {}

    record Piece(double a, double b, double c, double d) {
        DoubleStream numbers() {
            return DoubleStream.of(a, b, c, d);
        }
    }

    // the unknowns are the slopes k at the knots, not the second derivatives
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        boolean ordered = true;
        for (int i = 0; i < x.length; i++)
            ordered &= Math.abs(y[i]) < 1e300 && (i == 0 || x[i] - x[i - 1] > 0);
        if (!ordered) throw new IllegalArgumentException("these are no points of a function");
        int last = x.length - 1;
        List<Row> rows = new ArrayList<>();
        boolean given = ends.kind().equals(SplineEnds.Kind.SLOPES);
        rows.add(given ? new Row(0, 1, 0, ends.left()) : new Row(0, 2, 1, 3 * secant(x, y, 0)));
        for (int i = 1; i < last; i++) {
            double left = 1 / (x[i] - x[i - 1]);
            double right = 1 / (x[i + 1] - x[i]);
            double value = 3 * (left * secant(x, y, i - 1) + right * secant(x, y, i));
            rows.add(new Row(left, 2 * (left + right), right, value));
        }
        rows.add(
                given
                        ? new Row(0, 1, 0, ends.right())
                        : new Row(1, 2, 0, 3 * secant(x, y, last - 1)));
        double[] k = solve(rows);
        List<Piece> pieces = new ArrayList<>();
        for (int i = 0; i < last; i++) {
            double h = x[i + 1] - x[i];
            double s = secant(x, y, i);
            pieces.add(
                    new Piece(
                            y[i],
                            k[i],
                            (3 * s - 2 * k[i] - k[i + 1]) / h,
                            (k[i] + k[i + 1] - 2 * s) / (h * h)));
        }
        return pieces.stream().flatMapToDouble(Piece::numbers).toArray();
    }

    private static double secant(double[] x, double[] y, int i) {
        return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    }

    private static double[] solve(List<Row> rows) {
        int n = rows.size();
        double[] share = new double[n];
        double[] k = new double[n];
        for (int i = 0; i < n; i++) {
            Row row = rows.get(i);
            double own = row.own() - (i == 0 ? 0 : row.before() * share[i - 1]);
            share[i] = row.after() / own;
            k[i] = (row.value() - (i == 0 ? 0 : row.before() * k[i - 1])) / own;
        }
        for (int i = n - 2; i >= 0; i--) k[i] -= share[i] * k[i + 1];
        return k;
    }
}
