package rasterlab.engine.geometry;

/**
 * A sum of products m·2ᵉ, of which no factor's size takes a part beyond the range of doubles.
 *
 * <p>Each product is over 2 to the power of the largest one's exponent, so m is at most 4 times the
 * number of products in size, and only what is 10³⁰⁰ times smaller than the largest is lost.
 *
 * @param mantissa m
 * @param exponent e
 */
record ProductSum(double mantissa, int exponent) {
    /** The sum of all a[i]·b[i]; 0·2⁰ where each is 0. */
    static ProductSum of(double[] a, double[] b) {
        int most = Integer.MIN_VALUE;
        for (int i = 0; i < a.length; i++)
            if (a[i] != 0 && b[i] != 0)
                most = Math.max(most, Math.getExponent(a[i]) + Math.getExponent(b[i]));
        if (most == Integer.MIN_VALUE) return new ProductSum(0, 0);
        double sum = 0;
        for (int i = 0; i < a.length; i++)
            if (a[i] != 0 && b[i] != 0) sum += product(a[i], b[i], most);
        return new ProductSum(sum, most);
    }

    /** The product a·b·2⁻ᵉ. */
    private static double product(double a, double b, int e) {
        int ofA = Math.getExponent(a);
        int ofB = Math.getExponent(b);
        return Math.scalb(Math.scalb(a, -ofA) * Math.scalb(b, -ofB), ofA + ofB - e);
    }

    /**
     * This over another sum, not 0: beyond doubles infinite, and where it is nearer to 0 than any
     * double but 0, the smallest of its sign.
     */
    double over(ProductSum divisor) {
        double near1 = mantissa / divisor.mantissa;
        double quotient = Math.scalb(near1, exponent - divisor.exponent);
        return quotient == 0 && near1 != 0 ? Math.copySign(Double.MIN_VALUE, near1) : quotient;
    }
}
