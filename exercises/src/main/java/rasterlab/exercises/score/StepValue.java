package rasterlab.exercises.score;

import java.util.regex.Pattern;

/**
 * A value of a step as people are told it, such as {@code x = 3, y = (0.5, -2)}, with the signs of
 * a language.
 */
final class StepValue {
    private static final String NAME = "[\\p{L}_][\\w\\p{L}-]*";
    private static final String NUMBER = "-?\\d+(?:\\.\\d+)?(?:E[+-]?\\d+|·10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?";
    private static final Pattern TOLD = pattern();
    private static final Pattern POINT = Pattern.compile("(?<=\\d)\\.(?=\\d)");

    /** A power of ten as reports of earlier versions have it. */
    private static final Pattern POWER = Pattern.compile("(?<=\\d)E\\+?(-?\\d+)");

    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    private static final Pattern MINUS = Pattern.compile("(?<![\\w\\p{L}])-(?=\\d)");

    private StepValue() {}

    /** Rows stand in rows no deeper than pieces of a polygon do. */
    private static Pattern pattern() {
        String value = "(?:" + NUMBER + "|" + NAME + ")";
        for (int depth = 0; depth < 3; depth++)
            value = "(?:" + value + "|\\(" + listed(value) + "\\))";
        return Pattern.compile(listed("(?:" + NAME + " = )?" + value));
    }

    private static String listed(String value) {
        return value + "(?:, " + value + ")*+";
    }

    /** The value in other signs; a text that is no value as it is. */
    static String in(String value, String minus, char point, String apart) {
        if (!TOLD.matcher(value).matches()) return value;
        String powers = POWER.matcher(value).replaceAll(found -> "·10" + raised(found.group(1)));
        String listed = powers.replace(", ", apart);
        String pointed = POINT.matcher(listed).replaceAll(String.valueOf(point));
        return MINUS.matcher(pointed).replaceAll(minus);
    }

    private static String raised(String exponent) {
        var raised = new StringBuilder();
        for (char each : exponent.toCharArray())
            raised.append(each == '-' ? '⁻' : RAISED.charAt(each - '0'));
        return raised.toString();
    }
}
