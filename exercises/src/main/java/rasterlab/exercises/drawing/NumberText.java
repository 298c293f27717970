package rasterlab.exercises.drawing;

import java.math.BigDecimal;
import java.math.MathContext;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/**
 * Writes numbers for pictures and texts: with few digits, but as many as tell a wrong one from the
 * right one. The minus is a hyphen, as {@link rasterlab.exercises.score.Message} wants it.
 */
public final class NumberText {
    /** Significant digits of a number that need not be told from another one. */
    static final int USUAL_DIGITS = 6;

    /** Significant digits that tell any two doubles apart. */
    private static final int ALL_DIGITS = 17;

    private static final int LEAST_PLAIN_EXPONENT = -4;
    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private NumberText() {}

    /** A number with the usual digits. */
    public static String of(double value) {
        return of(value, USUAL_DIGITS);
    }

    /** The number with at most so many significant digits: −0.25, 1.5·10³⁰⁰, NaN, −∞, −0. */
    static String of(double value, int digits) {
        if (Double.isNaN(value)) return "NaN";
        if (Double.isInfinite(value)) return value > 0 ? "∞" : "-∞";
        if (value == 0) return 1 / value > 0 ? "0" : "-0";
        return written(new BigDecimal(value).round(new MathContext(digits)), digits);
    }

    /** All digits of a number that has only few. */
    static String exactly(BigDecimal number) {
        return written(number, USUAL_DIGITS);
    }

    /** Plain where its first digit is not far from the point. */
    private static String written(BigDecimal number, int longest) {
        BigDecimal shortest = number.stripTrailingZeros();
        int exponent = shortest.precision() - shortest.scale() - 1;
        if (exponent >= LEAST_PLAIN_EXPONENT && exponent < longest) return shortest.toPlainString();
        return shortest.movePointLeft(exponent).toPlainString() + "·10" + raised(exponent);
    }

    /** The fewest significant digits, from the usual ones on, with which the two look different. */
    static int telling(double one, double other) {
        for (int digits = USUAL_DIGITS; digits < ALL_DIGITS; digits++)
            if (!of(one, digits).equals(of(other, digits))) return digits;
        return Double.compare(one, other) == 0 ? USUAL_DIGITS : ALL_DIGITS;
    }

    /** The number or label as a picture writes it: with a minus sign. */
    static String inPicture(String number) {
        return number.replace('-', '−');
    }

    /**
     * The number as a picture in that language writes it: with its decimal sign and a minus sign.
     *
     * @param language such as "ru"
     */
    static String inPicture(String number, String language) {
        char point = DecimalFormatSymbols.getInstance(new Locale(language)).getDecimalSeparator();
        return inPicture(number).replace('.', point);
    }

    /** Whether the text of a number differs between languages. */
    static boolean hasFraction(String number) {
        return number.indexOf('.') >= 0;
    }

    /** The exponent as raised digits. */
    static String raised(int exponent) {
        var text = new StringBuilder(exponent < 0 ? "⁻" : "");
        String.valueOf(Math.abs(exponent))
                .chars()
                .forEach(c -> text.append(RAISED.charAt(c - '0')));
        return text.toString();
    }
}
