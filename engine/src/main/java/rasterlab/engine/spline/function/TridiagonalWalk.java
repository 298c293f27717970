package rasterlab.engine.spline.function;

/**
 * Solves a tridiagonal system row by row: down to eliminate, then up to substitute back.
 *
 * <p>Of rows i and i + 1 the pivot is the one whose leading number is the larger share of its row's
 * largest (scaled partial pivoting); a swap puts one number beside the upper diagonal. After i
 * steps down the first i columns are zero below the diagonal. 2·n − 1 steps for n unknowns, in
 * memory for n rows; each right-hand side is solved along.
 *
 * <p>Source: G. H. Golub, C. F. Van Loan, Matrix Computations, on banded systems.
 */
final class TridiagonalWalk implements SplineWalk {
    private final double[] lower;
    private final double[] diagonal;
    private final double[] upper;
    private final double[] beside;
    private final double[][] right;
    private final int n;
    private int row = -1;
    private boolean down = true;
    private double decision;
    private long swaps;

    /**
     * Takes the arrays over and overwrites them.
     *
     * @param lower left of the diagonal; lower[0] is not looked at
     * @param upper right of the diagonal; its last number is not looked at
     * @param right right-hand sides; each becomes its solution
     */
    TridiagonalWalk(double[] lower, double[] diagonal, double[] upper, double[]... right) {
        this.lower = lower;
        this.diagonal = diagonal;
        this.upper = upper;
        this.right = right;
        n = diagonal.length;
        beside = new double[n];
        if (n > 0) upper[n - 1] = 0;
    }

    /** Takes all remaining steps. */
    void drain() {
        while (advance()) continue;
    }

    @Override
    public boolean advance() {
        if (down && row < n - 2) {
            row++;
            eliminate(row, row + 1);
            return true;
        }
        if (down) row = n;
        down = false;
        if (row <= 0) return false;
        row--;
        substitute(row);
        return true;
    }

    private void eliminate(int i, int next) {
        double size = largest(diagonal[i], upper[i], beside[i]);
        double sizeNext = largest(lower[next], diagonal[next], upper[next]);
        if (Math.abs(lower[next]) * size > Math.abs(diagonal[i]) * sizeNext) swap(i, next);
        double factor = lower[next] / diagonal[i];
        diagonal[next] -= factor * upper[i];
        upper[next] -= factor * beside[i];
        for (double[] side : right) side[next] -= factor * side[i];
        decision = diagonal[i];
    }

    private void swap(int i, int next) {
        swaps++;
        double leading = diagonal[i];
        double second = upper[i];
        diagonal[i] = lower[next];
        upper[i] = diagonal[next];
        beside[i] = upper[next];
        lower[next] = leading;
        diagonal[next] = second;
        upper[next] = 0;
        for (double[] side : right) {
            double kept = side[i];
            side[i] = side[next];
            side[next] = kept;
        }
    }

    private void substitute(int i) {
        if (diagonal[i] == 0)
            throw new IllegalArgumentException("x: the equations of the spline are singular");
        for (double[] side : right) {
            double rest = side[i];
            if (i + 1 < n) rest -= upper[i] * side[i + 1];
            if (i + 2 < n) rest -= beside[i] * side[i + 2];
            side[i] = rest / diagonal[i];
        }
        decision = right[0][i];
    }

    private static double largest(double a, double b, double c) {
        return Math.max(Math.abs(a), Math.max(Math.abs(b), Math.abs(c)));
    }

    @Override
    public int index() {
        return row;
    }

    @Override
    public String phase() {
        return down ? "eliminate" : "substitute";
    }

    /** The pivot on the way down, the solution on the way up. */
    @Override
    public double decision() {
        return decision;
    }

    @Override
    public long exceptions() {
        return swaps;
    }
}
