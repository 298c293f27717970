package rasterlab.engine.geometry;

/**
 * A number kept as the unrounded sum of several doubles.
 *
 * <p>The parts do not overlap: each is smaller than the lowest bit set in the next, and none is 0.
 * So the last part has the sign of the whole.
 *
 * <p>Source: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates, Discrete & Computational Geometry 18, 1997, pp. 305–363, grow-expansion with zero
 * elimination.
 */
public final class Expansion {
    private final double[] parts;
    private int size;

    /**
     * @param most number of terms that will be added, at most; a product counts as two
     */
    public Expansion(int most) {
        parts = new double[most];
    }

    /** Adds a·b; its error a·b − (a ⊗ b) must be a double. */
    public void addProduct(double a, double b) {
        double product = a * b;
        add(Math.fma(a, b, -product));
        add(product);
    }

    /** Adds one term by a chain of two-sums: each passes its rounded sum on, its error stays. */
    public void add(double term) {
        double carry = term;
        int kept = 0;
        for (int i = 0; i < size; i++) {
            double part = parts[i];
            double sum = carry + part;
            double partVirtual = sum - carry;
            double error = (carry - (sum - partVirtual)) + (part - partVirtual);
            if (error != 0) parts[kept++] = error;
            carry = sum;
        }
        if (carry != 0) parts[kept++] = carry;
        size = kept;
    }

    /** Adds another sum, part by part. */
    public void add(Expansion other) {
        for (int i = 0; i < other.size; i++) add(other.parts[i]);
    }

    /** Subtracts another sum, part by part. */
    public void subtract(Expansion other) {
        for (int i = 0; i < other.size; i++) add(-other.parts[i]);
    }

    /** The sum rounded to a double, off by at most one unit in its last place. */
    public double value() {
        double sum = 0;
        for (int i = 0; i < size; i++) sum += parts[i];
        return sum;
    }

    /** −1, 0 or 1. */
    public int sign() {
        return size == 0 ? 0 : parts[size - 1] > 0 ? 1 : -1;
    }
}
