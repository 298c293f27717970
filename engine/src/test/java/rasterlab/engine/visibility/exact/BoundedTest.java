package rasterlab.engine.visibility.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** The bound of an error against what the error is, in whole numbers. */
class BoundedTest {
    private static final long SEED = 53;
    private static final double[] BORDERS = {
        0, -0.0, Double.MIN_VALUE, Double.MIN_NORMAL, 1, Math.nextUp(1.0), 0x1p-600, 0x1p500, 3e-320
    };

    private final Random random = new Random(SEED);

    private double number() {
        int kind = random.nextInt(4);
        if (kind == 0) return BORDERS[random.nextInt(BORDERS.length)];
        double any = random.nextDouble(-1, 1);
        return kind == 1 ? any : Math.scalb(any, random.nextInt(-60, 60));
    }

    @Test
    @DisplayName("the error of a sum of products is larger than its bound")
    void boundHoldsTheError() {
        for (int k = 0; k < 20_000; k++) {
            double[] n = {number(), number(), number(), number(), number(), number()};
            Bounded near = formula(n, Bounded::of);
            Dyadic exact = formula(n, Dyadic::of);
            if (!Double.isFinite(near.value()) || !Double.isFinite(near.error())) continue;
            Dyadic error = exact.minus(Dyadic.of(near.value()));
            Dyadic bound = Dyadic.of(near.error());
            boolean held = bound.minus(error).signum() >= 0 && bound.plus(error).signum() >= 0;
            assertTrue(held, "seed %d, round %d: %s".formatted(SEED, k, near));
            if (near.certainSign() != 0) assertEquals(exact.signum(), near.certainSign());
        }
    }

    private static <S extends Scalar<S>> S formula(double[] n, DoubleFunction<S> number) {
        S difference = number.apply(n[0]).times(number.apply(n[1])).minus(number.apply(n[2]));
        return difference
                .times(number.apply(n[3]).plus(number.apply(n[4])))
                .minus(number.apply(n[5]).times(difference));
    }

    @Test
    @DisplayName("the error of a quotient is larger than its bound")
    void boundHoldsTheErrorOfAQuotient() {
        for (int k = 0; k < 20_000; k++) {
            double a = random.nextDouble(-1, 1);
            double b = random.nextDouble(-1, 1);
            double off = Math.scalb(1.0, -random.nextInt(4, 50));
            Bounded quotient = new Bounded(a, off).over(new Bounded(b, off));
            if (!Double.isFinite(quotient.error())) continue;
            Dyadic value = Dyadic.of(quotient.value());
            Dyadic error = Dyadic.of(quotient.error());
            for (int corner = 0; corner < 4; corner++) {
                Dyadic over = Dyadic.of(a).plus(Dyadic.of(corner % 2 == 0 ? off : -off));
                Dyadic under = Dyadic.of(b).plus(Dyadic.of(corner < 2 ? off : -off));
                int below = over.minus(value.minus(error).times(under)).signum();
                int above = value.plus(error).times(under).minus(over).signum();
                assertTrue(
                        below * under.signum() >= 0 && above * under.signum() >= 0,
                        "seed %d: %s / %s ± %s".formatted(SEED, a, b, off));
            }
        }
    }

    @Test
    @DisplayName("a divisor that may be 0 has a quotient with a bound")
    void quotientByWhatMayBeNothingHasNoBound() {
        assertEquals(0, Bounded.of(1).over(new Bounded(1e-9, 1e-9)).certainSign());
        assertEquals(0, Bounded.of(1).over(Bounded.of(0)).certainSign());
    }

    @Test
    @DisplayName("a double is read as another number")
    void dyadicIsTheDouble() {
        for (double value :
                new double[] {
                    3, -0.1, 0x1p-1074, -0x1.8p-1050, 0x1.fffffffffffffp1023, 12345.678
                }) {
            Dyadic read = Dyadic.of(value);
            double back =
                    new BigDecimal(read.mantissa())
                            .multiply(
                                    read.exponent() >= 0
                                            ? new BigDecimal(2).pow(read.exponent())
                                            : new BigDecimal("0.5").pow(-read.exponent()))
                            .doubleValue();
            assertEquals(value, back);
        }
    }
}
