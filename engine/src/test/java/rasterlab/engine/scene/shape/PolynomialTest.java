package rasterlab.engine.scene.shape;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class PolynomialTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void findsTheRoots(double[] expected, double... coefficients) {
        assertArrayEquals(expected, roots(coefficients), 1e-7);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("x = 0 is no root", new double[] {0}, new double[] {0, 1}),
                argumentSet("the range's end is cut off", new double[] {1}, new double[] {-1, 1}),
                argumentSet(
                        "the range's start is left out", new double[] {-1}, new double[] {1, 1}),
                argumentSet("the range has no end", new double[] {}, new double[] {-2, 1}),
                argumentSet("a touch is lost", new double[] {0.5}, new double[] {.25, -1, 1}),
                argumentSet("a near miss touches", new double[] {}, new double[] {.250001, -1, 1}),
                argumentSet(
                        "four roots are two",
                        new double[] {-0.8, -0.1, 0.1, 0.8},
                        new double[] {0.0064, 0, -0.65, 0, 1}),
                argumentSet("0 has roots everywhere", new double[] {}, new double[7]),
                argumentSet(
                        "leading zeros hide a root",
                        new double[] {0.25},
                        new double[] {-1, 4, 0, 0, 0, 0, 0}),
                argumentSet(
                        "a root of fifth order never ends",
                        new double[] {0},
                        new double[] {0, 0, 0, 0, 0, 1}));
    }

    /** Products of (x − root), multiplied out in decimals and rounded once. */
    @Test
    @DisplayName("one of six simple roots is lost")
    void findsAllOfSix() {
        for (int seed = 0; seed < 2_000; seed++) {
            var random = new Random(seed);
            double[] roots = new double[6];
            for (int i = 0; i < 6; i++) roots[i] = -0.95 + 0.3 * i + 0.2 * random.nextDouble();
            assertArrayEquals(roots, roots(product(roots)), 1e-9, "seed " + seed);
        }
    }

    private static double[] product(double[] roots) {
        var product = new BigDecimal[roots.length + 1];
        Arrays.fill(product, BigDecimal.ZERO);
        product[0] = BigDecimal.ONE;
        for (int i = 0; i < roots.length; i++)
            for (int k = i + 1; k >= 0; k--) {
                BigDecimal lower = k > 0 ? product[k - 1] : BigDecimal.ZERO;
                product[k] = lower.subtract(product[k].multiply(new BigDecimal(roots[i])));
            }
        return Arrays.stream(product).mapToDouble(BigDecimal::doubleValue).toArray();
    }

    /** Equal ones once. */
    private static double[] roots(double... coefficients) {
        var polynomial = new Polynomial(6);
        double[] f = polynomial.start(coefficients.length - 1);
        System.arraycopy(coefficients, 0, f, 0, coefficients.length);
        double[] roots = new double[polynomial.roots(-1, 1)];
        for (int i = 0; i < roots.length; i++) roots[i] = polynomial.root(i);
        return Arrays.stream(roots).distinct().toArray();
    }
}
