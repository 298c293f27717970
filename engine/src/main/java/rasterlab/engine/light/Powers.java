package rasterlab.engine.light;

/** Powers of cosines. */
public final class Powers {
    private Powers() {}

    /**
     * The base to a power; a whole exponent by squaring, which is several times as fast and off by
     * at most exponent·2⁻⁵³ of the result. 0⁰ is 1.
     *
     * @param base 0 or more
     * @param exponent 0 to 200
     */
    public static double of(double base, double exponent) {
        int whole = (int) exponent;
        if (whole != exponent) return Math.pow(base, exponent);
        double power = 1;
        for (double square = base; whole > 0; whole >>= 1) {
            if ((whole & 1) != 0) power *= square;
            square *= square;
        }
        return power;
    }
}
