package rasterlab.engine.clip;

/** Refuses numbers that name no place. */
final class FiniteNumbers {
    private FiniteNumbers() {}

    /**
     * @throws IllegalArgumentException if {@code value} is NaN or infinite
     */
    static void require(String name, double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException(name + " must be a finite number, got " + value);
    }

    /**
     * @throws IllegalArgumentException if a value is not finite or the first is the larger one
     */
    static void requireOrdered(String lowName, double low, String highName, double high) {
        require(lowName, low);
        require(highName, high);
        if (low > high)
            throw new IllegalArgumentException(
                    lowName + " must be at most " + highName + ", got " + low + " > " + high);
    }
}
