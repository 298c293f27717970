package rasterlab.exercises.complaint;

import java.math.BigDecimal;
import java.math.MathContext;
import java.text.DecimalFormatSymbols;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Numbers that Java has written, in the form of a language and with the same digits. */
final class NumberForm {
    private static final Pattern NUMBER =
            Pattern.compile("(-?)(Infinity|NaN|\\d+)(?:\\.(\\d+)(?:(?:E|e\\+0?)(-?\\d+))?)?");

    /** One, or several such as a point. */
    private static final Pattern NUMBERS =
            Pattern.compile("[\\[(]*%1$s(?:, %1$s)*[])]*".formatted(NUMBER.pattern()));

    /** Java's fraction of a whole number, and its capital in front of an exponent. */
    private static final Pattern JAVA = Pattern.compile("\\.0(?!\\d)(?:E(?=-?\\d))?|E(?=-?\\d)");

    /** Matches a quotation, or a number with Java's capital E outside names and paths. */
    private static final Pattern POWER =
            Pattern.compile(
                    Quotes.QUOTED
                            + "|(?<![\\p{L}\\p{N}_/\\\\]|[^.]\\.)(?<power>-?\\d+(?:\\.\\d+)?E-?\\d+)"
                            + "(?![\\p{L}\\p{N}_/\\\\]|\\.[\\p{L}\\p{N}])");

    private static final MathContext DIGITS = new MathContext(6);
    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private NumberForm() {}

    /** The text itself where it is something else, such as a number as a file has it: 1e309. */
    static String of(String text, Locale language) {
        if (!NUMBERS.matcher(text).matches()) return text;
        char point = DecimalFormatSymbols.getInstance(language).getDecimalSeparator();
        boolean fractions = point == ',' && text.contains(".");
        return NUMBER.matcher(fractions ? text.replace(", ", "; ") : text)
                .replaceAll(number -> Matcher.quoteReplacement(one(number, point)));
    }

    /** The numbers as one types them: 3 and 1e-6 where Java writes 3.0 and 1.0E-6. */
    static String typed(String text) {
        if (!NUMBERS.matcher(text).matches()) return text;
        return JAVA.matcher(text).replaceAll(found -> found.group().endsWith("E") ? "e" : "");
    }

    /** The sentence with each of Java's powers of ten outside quotation marks in another form. */
    static String powers(String sentence, UnaryOperator<String> form) {
        return POWER.matcher(sentence)
                .replaceAll(found -> Matcher.quoteReplacement(power(found, form)));
    }

    private static String power(MatchResult found, UnaryOperator<String> form) {
        String number = found.group(found.groupCount());
        if (number == null) return found.group();
        return form.apply(number.contains(".") ? number : number.replace("E", ".0E"));
    }

    /** The number to six digits; the text itself where it is something else. */
    static String rounded(String number, Locale language) {
        if (!NUMBER.matcher(number).matches() || !Double.isFinite(Double.parseDouble(number)))
            return of(number, language);
        double value = new BigDecimal(number).round(DIGITS).doubleValue();
        return of(String.valueOf(value), language);
    }

    private static String one(MatchResult number, char point) {
        String fraction = number.group(3);
        boolean whole = fraction == null || fraction.equals("0");
        String size = number.group(2).equals("Infinity") ? "∞" : number.group(2);
        String digits = size + (whole ? "" : point + fraction);
        if (number.group(4) != null) {
            String power = "10" + raised(number.group(4));
            digits = digits.equals("1") ? power : digits + "·" + power;
        }
        return number.group(1).isEmpty() ? digits : "−" + digits;
    }

    private static String raised(String exponent) {
        var raised = new StringBuilder();
        for (char each : exponent.toCharArray())
            raised.append(each == '-' ? '⁻' : RAISED.charAt(each - '0'));
        return raised.toString();
    }
}
