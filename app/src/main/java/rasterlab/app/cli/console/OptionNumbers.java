package rasterlab.app.cli.console;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Numbers as options take them. */
public final class OptionNumbers {
    private OptionNumbers() {}

    /** Decimal, also with an exponent; Infinity too, where an option allows it. */
    public static Double number(String text) {
        return number(text, "such as 2, 0.5 or 1e-3");
    }

    /**
     * The number that is typed.
     *
     * @param expected which numbers there are, told of what is none
     */
    public static Double number(String text, String expected) {
        try {
            return Double.valueOf(text.strip());
        } catch (NumberFormatException e) {
            throw new TypeConversionException(
                    "'" + text + "' is not a number; expected one " + expected);
        }
    }

    public static Integer whole(String text) {
        try {
            return Integer.valueOf(text.strip());
        } catch (NumberFormatException e) {
            throw new TypeConversionException(
                    text.strip().matches("[+-]?\\d+")
                            ? "'%s' is not a whole number from %d to %d"
                                    .formatted(text, Integer.MIN_VALUE, Integer.MAX_VALUE)
                            : "'" + text + "' is not a whole number; expected one such as 1 or 20");
        }
    }

    /** Whole numbers from 1 on. */
    public static final class FromOne implements ITypeConverter<Integer> {
        @Override
        public Integer convert(String text) {
            if (!text.strip().matches("[+-]?\\d+"))
                throw new TypeConversionException(
                        "'" + text + "' is not a whole number; expected one of at least 1");
            return whole(text);
        }
    }
}
