package rasterlab.app.canvas;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/**
 * Round numbers along an axis: the multiples of 1, 2 or 5 times a power of ten.
 *
 * @param digit 1, 2 or 5
 * @param exponent of ten
 */
public record RoundTicks(int digit, int exponent) {
    /** The number of digits from which on numbers are written with a power of ten. */
    private static final int LONG = 7;

    public RoundTicks {
        if (digit != 1 && digit != 2 && digit != 5)
            throw new IllegalArgumentException("digit must be 1, 2 or 5, got " + digit);
    }

    /** The closest ticks that are at least so far apart. */
    static RoundTicks atLeast(double distance) {
        int exponent = (int) Math.floor(Math.log10(distance));
        for (int digit : new int[] {1, 2, 5}) {
            var ticks = new RoundTicks(digit, exponent);
            if (ticks.step() >= distance) return ticks;
        }
        return new RoundTicks(1, exponent + 1);
    }

    /** A number with no decimals below the power of ten that is at most {@code least}. */
    public static double rounded(double value, double least) {
        int exponent = (int) Math.floor(Math.log10(least));
        double power = Math.pow(10, Math.abs(exponent));
        double round =
                exponent < 0 ? Math.rint(value * power) / power : Math.rint(value / power) * power;
        return Double.isFinite(round) ? round + 0.0 : value;
    }

    double step() {
        return value(1);
    }

    /** The tick of that number, tick 0 being at 0. */
    double value(long tick) {
        double power = Math.pow(10, Math.abs(exponent));
        return exponent < 0 ? tick * digit / power : tick * digit * power;
    }

    /** Number of the last tick at or before a place. */
    long before(double place) {
        return (long) Math.floor(place / step());
    }

    /** A tick as its axis writes it: with as many decimals as neighbours need. */
    String shown(long tick, Locale locale) {
        return shown(tick, locale, isLong());
    }

    /** Whether ticks are written with a power of ten. */
    boolean isLong() {
        return exponent < -LONG + 2 || exponent >= LONG - 1;
    }

    /** A tick over {@link #factor}. */
    String factored(long tick) {
        return String.valueOf(tick * digit).replace('-', '−');
    }

    /** The power of ten that all ticks have, such as ·10⁴. */
    String factor() {
        return Shown.withPower(("E" + exponent).replace('-', '−'));
    }

    /**
     * @param power whether with a power of ten, such as −6·10⁵
     */
    String shown(long tick, Locale locale, boolean power) {
        var symbols = DecimalFormatSymbols.getInstance(locale);
        symbols.setMinusSign('−');
        var format = new DecimalFormat(power ? "0.###E0" : "0", symbols);
        if (!power) {
            format.setMinimumFractionDigits(Math.max(0, -exponent));
            format.setMaximumFractionDigits(Math.max(0, -exponent));
        }
        return tick == 0 ? "0" : Shown.withPower(format.format(value(tick)));
    }
}
