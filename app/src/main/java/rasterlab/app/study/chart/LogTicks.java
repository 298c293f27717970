package rasterlab.app.study.chart;

import java.util.Locale;
import rasterlab.app.chart.PowersOfTen;

/** Numbers on a logarithmic axis: the multiples 1 to 9 of a power of ten, and how they are said. */
public final class LogTicks {
    /** The least number whose digits stand in groups of three. */
    private static final int GROUPED = 10_000;

    private LogTicks() {}

    /** Whether both are the same multiple, however they were computed. */
    static boolean same(double value, double other) {
        return Math.abs(value / other - 1) < 1e-6;
    }

    /** The multiple of a power of ten next to a value above 0. */
    static double nearestMultiple(double value) {
        double power = Math.pow(10, Math.floor(Math.log10(value)));
        return Math.round(value / power) * power;
    }

    /** A short decimal from 0.001 to a million, beyond that with a power of ten: "10⁻⁷". */
    public static String label(double value, Locale locale) {
        if (value >= 0.000999 && value < 999_999) {
            String form = value < GROUPED ? "%.3f" : "%,.3f";
            return String.format(locale, form, value).replaceFirst("[.,]?0+$", "");
        }
        return withPower(value, locale);
    }

    /** The value as a multiple of a power of ten with two digits at most: "1.5·10⁻¹²". */
    static String withPower(double value, Locale locale) {
        int power = (int) Math.floor(Math.log10(value * 1.005));
        String factor =
                String.format(locale, "%.1f", value / Math.pow(10, power))
                        .replaceFirst("[.,]0$", "");
        return (factor.equals("1") ? "" : factor + "·") + "10" + PowersOfTen.raised(power);
    }

    /** A size: its power of ten where it is one of more than four digits, as "10⁷". */
    static String size(int size) {
        String digits = String.valueOf(size);
        if (digits.length() < 5 || !digits.matches("10*")) return digits;
        return "10" + PowersOfTen.raised(digits.length() - 1);
    }
}
