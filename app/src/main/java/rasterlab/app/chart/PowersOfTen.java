package rasterlab.app.chart;

import java.util.stream.Collectors;

/** Powers of ten as they are written at an axis: "10⁻⁷". */
public final class PowersOfTen {
    private PowersOfTen() {}

    /** The power of ten next to a value above 0; "1" and "10" without an exponent. */
    public static String nearest(double value) {
        int exponent = (int) Math.round(Math.log10(value));
        return exponent == 0 ? "1" : exponent == 1 ? "10" : "10" + raised(exponent);
    }

    /** A whole number as an exponent: "⁻¹²". */
    public static String raised(int exponent) {
        String digits =
                String.valueOf(Math.abs(exponent))
                        .chars()
                        .mapToObj(digit -> "⁰¹²³⁴⁵⁶⁷⁸⁹".substring(digit - '0', digit - '0' + 1))
                        .collect(Collectors.joining());
        return (exponent < 0 ? "⁻" : "") + digits;
    }
}
