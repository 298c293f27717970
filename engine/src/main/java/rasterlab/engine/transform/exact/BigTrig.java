package rasterlab.engine.transform.exact;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Sine and cosine of an angle in degrees, to 60 digits.
 *
 * <p>Whole turns are taken off exactly; the rest is converted by π from Machin's formula, π/4 =
 * 4·arctan(1/5) − arctan(1/239) (J. Machin, 1706), and put into Taylor's series.
 */
public final class BigTrig {
    /** The precision of everything in this package. */
    public static final MathContext DIGITS = new MathContext(60);

    private static final MathContext MORE = new MathContext(80);
    private static final BigDecimal TINY = new BigDecimal("1e-75");
    private static final BigDecimal TURN = BigDecimal.valueOf(360);
    private static final BigDecimal HALF_TURN = BigDecimal.valueOf(180);
    private static final BigDecimal PI =
            arctanOfInverse(5)
                    .multiply(BigDecimal.valueOf(16))
                    .subtract(arctanOfInverse(239).multiply(BigDecimal.valueOf(4)));

    private final BigDecimal radians;
    private final boolean turned;

    private BigTrig(BigDecimal radians, boolean turned) {
        this.radians = radians;
        this.turned = turned;
    }

    /** The angle of so many degrees. */
    public static BigTrig ofDegrees(BigDecimal degrees) {
        BigDecimal rest = degrees.remainder(TURN); // −360..360, exact
        if (rest.abs().compareTo(HALF_TURN) > 0)
            rest = rest.subtract(TURN.multiply(BigDecimal.valueOf(rest.signum())));
        boolean turned = rest.abs().compareTo(BigDecimal.valueOf(90)) > 0;
        if (turned) rest = rest.subtract(HALF_TURN.multiply(BigDecimal.valueOf(rest.signum())));
        return new BigTrig(rest.multiply(PI).divide(HALF_TURN, MORE), turned);
    }

    public static BigTrig ofDegrees(double degrees) {
        return ofDegrees(new BigDecimal(degrees));
    }

    public BigDecimal sin() {
        return signed(series(radians));
    }

    public BigDecimal cos() {
        // cos x = sin(π/2 − |x|), so that no digits are lost close to 90°, where it is nearly 0.
        BigDecimal rest = PI.divide(BigDecimal.valueOf(2), MORE).subtract(radians.abs());
        return signed(rest.abs().compareTo(TINY) < 0 ? BigDecimal.ZERO : series(rest));
    }

    private BigDecimal signed(BigDecimal value) {
        return (turned ? value.negate() : value).round(DIGITS);
    }

    /** sin x = x − x³/3! + x⁵/5! − …, |x| ≤ π/2. */
    private static BigDecimal series(BigDecimal x) {
        BigDecimal square = x.multiply(x, MORE);
        BigDecimal term = x;
        BigDecimal sum = x;
        BigDecimal smallest = x.abs().multiply(TINY);
        for (int n = 2; term.abs().compareTo(smallest) > 0; n += 2) {
            term =
                    term.multiply(square, MORE)
                            .divide(BigDecimal.valueOf((long) n * (n + 1)), MORE)
                            .negate();
            sum = sum.add(term, MORE);
        }
        return sum;
    }

    private static BigDecimal arctanOfInverse(int whole) {
        BigDecimal square = BigDecimal.valueOf((long) whole * whole);
        BigDecimal power = BigDecimal.ONE.divide(BigDecimal.valueOf(whole), 100, RoundingMode.DOWN);
        BigDecimal sum = BigDecimal.ZERO;
        for (int n = 1; power.signum() != 0; n += 2) {
            BigDecimal term = power.divide(BigDecimal.valueOf(n), 100, RoundingMode.DOWN);
            sum = n % 4 == 1 ? sum.add(term) : sum.subtract(term);
            power = power.divide(square, 100, RoundingMode.DOWN);
        }
        return sum;
    }
}
