package rasterlab.app.canvas;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/** Numbers as every lab writes them: few digits, the language's comma, a minus as wide as plus. */
public final class Shown {
    private static final double LONG = 1e6;

    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private Shown() {}

    /** At most four decimals; very large and very small ones with a power of ten. */
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
        return "(" + number(x, locale) + apart(locale) + number(y, locale) + ")";
    }

    /** What stands between numbers: a semicolon where they have a decimal comma. */
    public static String apart(Locale locale) {
        char comma = DecimalFormatSymbols.getInstance(locale).getDecimalSeparator();
        return comma == ',' ? "; " : ", ";
    }
}
