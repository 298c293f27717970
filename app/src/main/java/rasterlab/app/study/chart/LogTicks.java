package rasterlab.app.study.chart;

import java.util.Locale;

/** Numbers on a logarithmic axis: the multiples 1 to 9 of a power of ten, and how they are said. */
public final class LogTicks {
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

    /** A short decimal from 0.001 to a million, beyond that with an exponent: "1e-7". */
    public static String label(double value, Locale locale) {
        if (value >= 0.000999 && value < 999_999)
            return String.format(locale, "%.3f", value).replaceFirst("[.,]?0+$", "");
        int power = (int) Math.floor(Math.log10(value) + 1e-9);
        return Math.round(value / Math.pow(10, power)) + "e" + power;
    }

    /** A size: its power of ten where it is one of more than four digits, as "10⁷". */
    static String size(int size) {
        String digits = String.valueOf(size);
        if (digits.length() < 5 || !digits.matches("10*")) return digits;
        return "10" + "⁰¹²³⁴⁵⁶⁷⁸⁹".charAt(digits.length() - 1);
    }
}
