import java.util.Arrays;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;

public class AllAtOnce implements SplineFunction {
    // 4m unknowns, 4m - 2 equations of the knots, two of the ends; Gauss with the largest pivot
    private double[][] rows;
    private int count;

    @Override
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        int m = x.length - 1;
        for (int i = 0; i <= m; i++) {
            if (Double.isNaN(x[i] - x[i]) || Double.isNaN(y[i] - y[i]))
                throw new IllegalArgumentException("no finite number at " + i);
            if (i > 0 && !(x[i - 1] < x[i])) throw new IllegalArgumentException("x[" + i + "]");
        }
        rows = new double[4 * m][4 * m + 1];
        count = 0;
        for (int i = 0; i < m; i++) {
            double h = x[i + 1] - x[i];
            add(i, new double[] {1, 0, 0, 0}, y[i]);
            add(i, new double[] {1, h, h * h, h * h * h}, y[i + 1]);
            if (i == m - 1) continue;
            add(i, new double[] {0, 1, 2 * h, 3 * h * h}, 0);
            rows[count - 1][4 * i + 5] = -1;
            add(i, new double[] {0, 0, 2, 6 * h}, 0);
            rows[count - 1][4 * i + 6] = -2;
        }
        double h = x[m] - x[m - 1];
        switch (ends.kind()) {
            case NATURAL -> {
                add(0, new double[] {0, 0, 2, 0}, 0);
                add(m - 1, new double[] {0, 0, 2, 6 * h}, 0);
            }
            case SLOPES -> {
                add(0, new double[] {0, 1, 0, 0}, ends.left());
                add(m - 1, new double[] {0, 1, 2 * h, 3 * h * h}, ends.right());
            }
            default -> throw new UnsupportedOperationException("other ends");
        }
        return gauss();
    }

    private void add(int piece, double[] of, double value) {
        System.arraycopy(of, 0, rows[count], 4 * piece, 4);
        rows[count][rows.length] = value;
        count++;
    }

    private double[] gauss() {
        int n = rows.length;
        for (int c = 0; c < n; c++) {
            int best = c;
            for (int r = c; r < n; r++)
                if (Math.abs(rows[r][c]) > Math.abs(rows[best][c])) best = r;
            double[] pivot = rows[best];
            rows[best] = rows[c];
            rows[c] = pivot;
            for (int r = 0; r < n; r++) {
                double factor = r == c ? 0 : rows[r][c] / pivot[c];
                if (factor != 0) for (int k = c; k <= n; k++) rows[r][k] -= factor * pivot[k];
            }
        }
        double[] answer = new double[n];
        Arrays.setAll(answer, r -> rows[r][n] / rows[r][r]);
        return answer;
    }
}
