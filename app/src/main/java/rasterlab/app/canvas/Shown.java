package rasterlab.app.canvas;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/** Numbers as every lab writes them: few digits, the language's comma, a minus as wide as plus. */
public final class Shown {
    private static final double LONG = 1e6;

    /** The error, as a share, that some thousand roundings of a double make. */
    private static final double ROUNDING = 1e-12;

    /**
     * The largest number that may be a rounding error of one that is read without a power of ten.
     */
    private static final double SMALL = 1e-6;

    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private Shown() {}

    /**
     * The number with at most four decimals; very large and very small ones with a power of ten.
     */
    public static String number(double value, Locale locale) {
        return number(value, 4, locale);
    }

    /**
     * @param decimals at most so many
     */
    public static String number(double value, int decimals, Locale locale) {
        if (!Double.isFinite(value)) return Double.toString(value).replace('-', '−');
        var symbols = DecimalFormatSymbols.getInstance(locale);
        symbols.setMinusSign('−');
        double size = Math.abs(value);
        boolean power = size >= LONG && value != Math.rint(value) || size >= 1e10;
        boolean tiny = size > 0 && size < Math.pow(10, -decimals);
        var format = new DecimalFormat(power || tiny ? "0.##E0" : "0.#", symbols);
        if (!power && !tiny) format.setMaximumFractionDigits(decimals);
        String text = withPower(format.format(value));
        return text.equals("−0") ? "0" : text;
    }

    /**
     * A coordinate, or a part of a direction, beside others: rounding reads as 0. What is no small
     * number by itself stays: 5 beside 10³⁰ may be given.
     *
     * @param largest of all that stand there, in magnitude
     * @param decimals at most so many
     */
    public static String coordinate(double value, double largest, int decimals, Locale locale) {
        double rest = Double.isFinite(largest) ? ROUNDING * Math.abs(largest) : 0;
        boolean rounding = Math.abs(value) <= Math.min(rest, SMALL);
        return number(rounding ? 0 : value, decimals, locale);
    }

    /** {@code 1.5·10⁻⁷} for {@code 1.5E−7}. */
    static String withPower(String number) {
        int mark = number.indexOf('E');
        if (mark < 0) return number;
        var raised = new StringBuilder();
        for (char each : number.substring(mark + 1).toCharArray())
            raised.append(each == '−' ? '⁻' : RAISED.charAt(each - '0'));
        return number.substring(0, mark) + "·10" + raised;
    }

    /** {@code (x, y)}, with what stands between numbers in that language. */
    public static String point(double x, double y, Locale locale) {
        double largest = Math.max(Math.abs(x), Math.abs(y));
        return "("
                + coordinate(x, largest, 4, locale)
                + apart(locale)
                + coordinate(y, largest, 4, locale)
                + ")";
    }

    /** The separator between numbers: a semicolon where they have a decimal comma. */
    public static String apart(Locale locale) {
        char comma = DecimalFormatSymbols.getInstance(locale).getDecimalSeparator();
        return comma == ',' ? "; " : ", ";
    }
}
