package rasterlab.engine.scene.shape;

/**
 * Real roots of a polynomial in a range, by its derivatives.
 *
 * <p>Between two neighbouring roots of its derivative a polynomial only rises or only falls, so it
 * has one root there if its signs at both ends differ and none otherwise. That goes down from the
 * last derivative, which is linear, to the polynomial. A root with a change of sign is kept between
 * two places of different sign until they are 2⁻⁵² apart: Newton's steps, every other one replaced
 * by halving, so at most about 110. Where the polynomial touches 0 without changing sign, a root of
 * its derivative counts if the value there is at most 2⁻⁴⁸ of the sum of the terms' magnitudes,
 * which is what rounding makes of 0.
 */
final class Polynomial {
    private static final double TOUCHES = 0x1p-48;
    private static final double APART = 0x1p-52;

    /** Row k is the k-th derivative; column i belongs to power i. */
    private final double[][] rows;

    private int degree;
    private double[] roots;
    private double[] bends;

    Polynomial(int mostDegree) {
        rows = new double[mostDegree + 1][mostDegree + 1];
        roots = new double[2 * mostDegree + 2];
        bends = new double[2 * mostDegree + 2];
    }

    /** The coefficients to write, one for each power from 0 to {@code degree}. */
    double[] start(int degree) {
        this.degree = degree;
        return rows[0];
    }

    /** The root with this number, from the lowest. */
    double root(int i) {
        return roots[i];
    }

    /**
     * Finds the roots from {@code low} to {@code high} in rising order; close ones may come twice.
     *
     * @param low at least −2: beyond, neighbouring doubles are farther apart than 2⁻⁵²
     * @param high at most 2, likewise
     * @return how many; 0 where all coefficients are 0
     */
    int roots(double low, double high) {
        for (int k = 1; k < degree; k++)
            for (int i = 0; i <= degree - k; i++) rows[k][i] = (i + 1) * rows[k - 1][i + 1];
        int count = 0;
        for (int k = degree - 1; k >= 0; k--) {
            double[] spare = bends;
            bends = roots;
            roots = spare;
            count = between(k, count, low, high);
        }
        return count;
    }

    /** Roots of row k, whose pieces the first {@code bendCount} of bends divide. */
    private int between(int k, int bendCount, double low, double high) {
        int count = 0;
        double from = low;
        double atFrom = value(k, low);
        if (atFrom == 0 && slope(k, low) != 0) roots[count++] = low;
        for (int i = 0; i <= bendCount; i++) {
            double to = i < bendCount ? bends[i] : high;
            double atTo = value(k, to);
            if (atFrom < 0 && atTo > 0 || atFrom > 0 && atTo < 0)
                roots[count++] = crossing(k, from, to, atFrom < 0);
            else if (isRoot(k, to, atTo, i < bendCount)) roots[count++] = to;
            from = to;
            atFrom = atTo;
        }
        return count;
    }

    private boolean isRoot(int k, double at, double value, boolean bend) {
        if (!bend) return value == 0 && slope(k, at) != 0;
        return Math.abs(value) <= TOUCHES * magnitude(k, at);
    }

    /** The place between two of different sign where row k has its root. */
    private double crossing(int k, double from, double to, boolean rising) {
        double low = from;
        double high = to;
        double x = low + (high - low) / 2;
        boolean newton = true;
        while (high - low > APART) {
            double y = value(k, x);
            if (y == 0) return x;
            if (y < 0 == rising) low = x;
            else high = x;
            double next = x - y / slope(k, x);
            if (Math.abs(next - x) <= APART / 2) return Math.max(low, Math.min(next, high));
            boolean useful = newton && next > low && next < high;
            x = useful ? next : low + (high - low) / 2;
            newton = !newton;
        }
        return x;
    }

    private double value(int k, double x) {
        double[] row = rows[k];
        double value = row[degree - k];
        for (int i = degree - k - 1; i >= 0; i--) value = value * x + row[i];
        return value;
    }

    private double slope(int k, double x) {
        double[] row = rows[k];
        double slope = (degree - k) * row[degree - k];
        for (int i = degree - k - 1; i >= 1; i--) slope = slope * x + i * row[i];
        return slope;
    }

    private double magnitude(int k, double x) {
        double[] row = rows[k];
        double size = Math.abs(x);
        double sum = Math.abs(row[degree - k]);
        for (int i = degree - k - 1; i >= 0; i--) sum = sum * size + Math.abs(row[i]);
        return sum;
    }
}
