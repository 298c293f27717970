package rasterlab.engine.line;

/** The bound on a line's length that a proof about rounding rests on. */
final class ProvedSteps {
    private ProvedSteps() {}

    /**
     * @param steps n = max(|x1 − x0|, |y1 − y0|)
     * @throws IllegalArgumentException if it is above {@code most}
     */
    static int checked(long steps, int most) {
        if (steps > most)
            throw new IllegalArgumentException(
                    "n = max(|x1 − x0|, |y1 − y0|) must be from 0 to "
                            + most
                            + " steps, where rounding is proved harmless; got "
                            + steps);
        return (int) steps;
    }
}
