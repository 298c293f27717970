package rasterlab.app.cli.console;

import picocli.CommandLine.TypeConversionException;

/** Numbers as options take them. */
public final class OptionNumbers {
    private OptionNumbers() {}

    /** Decimal, also with an exponent; Infinity too, where an option allows it. */
    public static Double number(String text) {
        try {
            return Double.valueOf(text.strip());
        } catch (NumberFormatException e) {
            throw new TypeConversionException(
                    "'" + text + "' is not a number; expected one such as 2, 0.5 or 1e-3");
        }
    }

    public static Integer whole(String text) {
        try {
            return Integer.valueOf(text.strip());
        } catch (NumberFormatException e) {
            throw new TypeConversionException(
                    "'%s' is not a whole number from %d to %d"
                            .formatted(text, Integer.MIN_VALUE, Integer.MAX_VALUE));
        }
    }
}
