package rasterlab.engine.circle;

import java.math.BigInteger;

/** Where an ellipse becomes steeper than 45°. */
final class LastColumn {
    private LastColumn() {}

    /** The whole number nearest to a²/√(a² + b²), exactly; 0 where both half-axes are 0. */
    static int of(int a, int b) {
        if (a == 0) return 0;
        BigInteger squares = BigInteger.valueOf((long) a * a + (long) b * b);
        BigInteger doubled = BigInteger.valueOf(a).pow(4).shiftLeft(2).divide(squares).sqrt();
        return (doubled.intValueExact() + 1) / 2;
    }
}
