package rasterlab.exercises.drawing;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;

/**
 * Round numbers along an axis. Where they are long, a note holds what all have in common: a label
 * stands for {@code label·10ᵏ + offset}.
 *
 * @param note such as {@code ·10³⁰⁰ + 2·10³⁰⁷}; empty where labels are the numbers themselves
 */
record AxisTicks(List<AxisTick> ticks, String note) {
    /**
     * A round number.
     *
     * @param value the double next to it
     */
    record AxisTick(double value, String label) {}

    /** Four digits, or a leading 1 and four: what lies around a power of ten. */
    private static final BigInteger LONGEST = BigInteger.valueOf(19_999);

    private static final BigInteger OFFSET_UNIT = BigInteger.valueOf(1000);
    private static final int SMALLEST_PLAIN = -4;
    private static final int LARGEST_PLAIN = 4;
    private static final BigDecimal TOO_LONG = BigDecimal.valueOf(100_000);

    /** Multiples of 1, 2 or 5 times a power of ten, at most {@code most} + 1 of them. */
    static AxisTicks of(AxisRange range, int most) {
        var low = new BigDecimal(range.low());
        var high = new BigDecimal(range.high());
        BigDecimal least =
                high.subtract(low).divide(BigDecimal.valueOf(most), MathContext.DECIMAL64);
        int exponent = least.precision() - least.scale() - 1;
        BigDecimal power = BigDecimal.ONE.scaleByPowerOfTen(exponent);
        int digit = 1;
        for (int larger : new int[] {2, 5, 10})
            if (power.multiply(BigDecimal.valueOf(digit)).compareTo(least) < 0) digit = larger;
        BigDecimal step = power.multiply(BigDecimal.valueOf(digit));
        if (digit == 10) {
            digit = 1;
            exponent++;
        }
        BigInteger first = low.divide(step, 0, RoundingMode.CEILING).toBigInteger();
        BigInteger last = high.divide(step, 0, RoundingMode.FLOOR).toBigInteger();
        var multiples = new ArrayList<BigInteger>();
        for (BigInteger n = first; n.compareTo(last) <= 0; n = n.add(BigInteger.ONE))
            multiples.add(n.multiply(BigInteger.valueOf(digit)));
        return labelled(multiples, exponent);
    }

    /** Ticks at these multiples of a power of ten. */
    private static AxisTicks labelled(List<BigInteger> multiples, int exponent) {
        BigInteger longest =
                multiples.stream().map(BigInteger::abs).reduce(BigInteger.ZERO, BigInteger::max);
        BigInteger offset =
                longest.compareTo(LONGEST) <= 0
                        ? BigInteger.ZERO
                        : multiples.get(0).divide(OFFSET_UNIT).multiply(OFFSET_UNIT);
        List<BigInteger> labels = multiples.stream().map(n -> n.subtract(offset)).toList();
        BigInteger longestLabel =
                labels.stream().map(BigInteger::abs).reduce(BigInteger.ZERO, BigInteger::max);
        boolean plain =
                exponent >= SMALLEST_PLAIN
                        && exponent <= LARGEST_PLAIN
                        && number(longestLabel, exponent).compareTo(TOO_LONG) < 0;
        int power = plain ? 0 : exponent + longestLabel.toString().length() - 1;
        var ticks = new ArrayList<AxisTick>();
        for (int i = 0; i < labels.size(); i++)
            ticks.add(
                    new AxisTick(
                            number(multiples.get(i), exponent).doubleValue(),
                            NumberText.inPicture(
                                    number(labels.get(i), exponent - power).toPlainString())));
        return new AxisTicks(List.copyOf(ticks), note(power, number(offset, exponent)));
    }

    private static String note(int exponent, BigDecimal offset) {
        String power = exponent == 0 ? "" : "·10" + NumberText.raised(exponent);
        if (offset.signum() == 0) return power;
        String sign = offset.signum() > 0 ? "+" : "−";
        return (power + " " + sign + " " + NumberText.exactly(offset.abs())).strip();
    }

    private static BigDecimal number(BigInteger multiple, int exponent) {
        BigDecimal number = new BigDecimal(multiple).scaleByPowerOfTen(exponent);
        return number.signum() == 0 ? BigDecimal.ZERO : number;
    }
}
