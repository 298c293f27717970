package rasterlab.engine.range;

/** Refuses numbers outside of their range. */
public final class Bounds {
    private Bounds() {}

    /**
     * Passes if the number is from {@code least} to {@code most}.
     *
     * @param name what it is
     * @throws IllegalArgumentException naming it
     */
    public static void require(String name, int value, int least, int most) {
        if (value < least || value > most)
            throw new IllegalArgumentException(
                    "%s must be from %d to %d, got %d".formatted(name, least, most, value));
    }

    /**
     * Passes if the number is from {@code least} to {@code most}; one that is no number is not.
     *
     * @param name what it is
     * @throws IllegalArgumentException naming it
     */
    public static void require(String name, double value, double least, double most) {
        if (!(value >= least && value <= most))
            throw new IllegalArgumentException(
                    "%s must be from %s to %s, got %s".formatted(name, least, most, value));
    }

    /**
     * Passes if the number is at least {@code least}.
     *
     * @param name what it is
     * @throws IllegalArgumentException naming it
     */
    public static void requireAtLeast(String name, int value, int least) {
        if (value < least)
            throw new IllegalArgumentException(
                    "%s must be at least %d, got %d".formatted(name, least, value));
    }

    /**
     * Passes if the number is at least {@code least}; one that is no number is not.
     *
     * @param name what it is
     * @throws IllegalArgumentException naming it
     */
    public static void requireAtLeast(String name, double value, double least) {
        if (!(value >= least))
            throw new IllegalArgumentException(
                    "%s must be at least %s, got %s".formatted(name, least, value));
    }

    /**
     * Passes if the number is 1 or −1.
     *
     * @param name what it is
     * @throws IllegalArgumentException naming it
     */
    public static void requireSign(String name, int value) {
        if (value != 1 && value != -1)
            throw new IllegalArgumentException(name + " must be 1 or -1, got " + value);
    }
}
