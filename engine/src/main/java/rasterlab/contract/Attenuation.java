package rasterlab.contract;

/**
 * How light grows weaker with the distance d: 1/(constant + linear·d + quadratic·d²).
 *
 * @param constant 0 or more
 * @param linear 0 or more
 * @param quadratic 0 or more; not all three are 0
 */
public record Attenuation(double constant, double linear, double quadratic) {
    public Attenuation {
        require("constant", constant);
        require("linear", linear);
        require("quadratic", quadratic);
        if (constant == 0 && linear == 0 && quadratic == 0)
            throw new IllegalArgumentException(
                    "attenuation needs a number above 0, got 0, 0 and 0");
    }

    private static void require(String name, double value) {
        if (!(value >= 0 && value < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "attenuation's %s must be finite and not negative, got %s"
                            .formatted(name, value));
    }

    /** No attenuation: as much light everywhere. */
    public static Attenuation none() {
        return new Attenuation(1, 0, 0);
    }

    /** 1/(r + d²), the course's first form; r of 1 or more keeps it from brightening. */
    public static Attenuation bySquare(double r) {
        return new Attenuation(r, 0, 1);
    }

    /** The factor at a distance; infinite where the light stands in the point and constant is 0. */
    public double factor(double distance) {
        return 1 / (constant + distance * (linear + distance * quadratic));
    }
}
