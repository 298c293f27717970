package rasterlab.app.canvas.widget;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The numbers that a typed text may be.
 *
 * <p>A number has a sign (−, - or +) or none, a whole part, a decimal sign with a fraction, and a
 * power of ten as in {@code 1.5e-7}; the last two may be missing. In every language both the point
 * and the comma are decimal signs. Groups of three digits may be set off by spaces, and by the
 * language's own group sign; then the other of point and comma is the decimal sign. Where a text
 * reads in both ways as different numbers, as {@code 1,234} does in English, it has both, and
 * nobody should guess: {@code 0,125}, {@code 1,23} and {@code 1,234.5} have one.
 */
final class TypedNumber {
    private static final String SIGN = "\\h*([+−-]?)\\h*(?=[.,]?\\d)";
    private static final String POWER = "([eE][+−-]?\\d+)?\\h*";
    private static final String SPACED = "\\d*|[1-9]\\d{0,2}(?:\\h\\d{3})+";

    private final List<Pattern> ways;

    /**
     * @param group what sets off groups of digits in the language
     */
    TypedNumber(char group) {
        String own = "[1-9]\\d{0,2}(?:" + Pattern.quote(String.valueOf(group)) + "\\d{3})+";
        ways = List.of(way(SPACED, "[.,]"), way(own, group == '.' ? "," : "\\."));
    }

    private static Pattern way(String whole, String decimal) {
        return Pattern.compile(SIGN + "(" + whole + ")(?:" + decimal + "(\\d*))?" + POWER);
    }

    /** The numbers that the text may be: none, one, or two where it reads in two ways. */
    List<Double> readings(String text) {
        List<Double> readings = new ArrayList<>();
        for (Pattern way : ways) {
            Matcher parts = way.matcher(text);
            if (!parts.matches()) continue;
            double number = number(parts);
            if (!readings.contains(number)) readings.add(number);
        }
        return readings;
    }

    private static double number(Matcher parts) {
        String whole = parts.group(2).replaceAll("\\D", "");
        String fraction = parts.group(3) == null ? "" : parts.group(3);
        String power = parts.group(4) == null ? "" : parts.group(4);
        String plain = parts.group(1) + "0" + whole + "." + fraction + "0" + power;
        return Double.parseDouble(plain.replace('−', '-'));
    }
}
