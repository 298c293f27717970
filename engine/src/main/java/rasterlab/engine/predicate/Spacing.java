package rasterlab.engine.predicate;

import java.util.Locale;

/** How far apart the neighbours of a number are: which numbers a method computes with. */
public enum Spacing {
    /** Next to each other among the doubles. */
    DOUBLE,
    /** Next to each other among the floats. */
    FLOAT,
    /** One apart, for methods in ints. */
    WHOLE;

    /**
     * The number that many steps above {@code base}.
     *
     * @param base above 0, and one of these numbers
     * @param steps at least 0
     */
    public double above(double base, int steps) {
        return switch (this) {
            case DOUBLE -> Double.longBitsToDouble(Double.doubleToRawLongBits(base) + steps);
            case FLOAT -> Float.intBitsToFloat(Float.floatToRawIntBits((float) base) + steps);
            case WHOLE -> base + steps;
        };
    }

    /** Lower-case name, as printed and stored. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }
}
