package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class TridiagonalWalkTest {
    @Test
    void rowsAreSwappedWhereThePivotIsZero() {
        double[] right = {2, 3, 4};
        var walk =
                new TridiagonalWalk(
                        new double[] {0, 1, 2},
                        new double[] {0, 0, 1},
                        new double[] {2, 5, 0},
                        right);
        walk.drain();
        // 2·b = 2, a + 5·c = 3, 2·b + c = 4
        assertArrayEquals(new double[] {-7, 1, 2}, right, 1e-15);
        assertTrue(walk.exceptions() > 0);
    }

    @Test
    void pivotIsJudgedByItsOwnRow() {
        double[] right = {1, 2};
        // The upper row is the larger only because it was multiplied by 10²⁰.
        var walk =
                new TridiagonalWalk(
                        new double[] {0, 1}, new double[] {1, 1}, new double[] {1e20, 1}, right);
        walk.drain();
        assertEquals(1, walk.exceptions());
        assertEquals(2, right[0], 1e-12);
    }

    @Property(tries = 300)
    void solutionsSatisfyTheRows(@ForAll @IntRange(min = 1, max = 30) int n, @ForAll long seed) {
        var random = new Random(seed);
        double[] lower = random.doubles(n, -1, 1).toArray();
        double[] diagonal = random.doubles(n, -0.2, 0.2).toArray();
        double[] upper = random.doubles(n, -1, 1).toArray();
        double[] wanted = random.doubles(n, -1, 1).toArray();
        var right = new double[n];
        for (int i = 0; i < n; i++) right[i] = row(lower, diagonal, upper, wanted, i);
        double[] found = right.clone();
        new TridiagonalWalk(lower.clone(), diagonal.clone(), upper.clone(), found).drain();
        double largest = 1;
        for (double each : found) largest = Math.max(largest, Math.abs(each));
        for (int i = 0; i < n; i++)
            assertEquals(right[i], row(lower, diagonal, upper, found, i), 1e-12 * largest);
    }

    private static double row(double[] a, double[] b, double[] c, double[] v, int i) {
        double sum = b[i] * v[i];
        if (i > 0) sum += a[i] * v[i - 1];
        if (i + 1 < v.length) sum += c[i] * v[i + 1];
        return sum;
    }
}
