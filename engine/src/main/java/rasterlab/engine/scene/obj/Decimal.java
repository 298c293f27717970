package rasterlab.engine.scene.obj;

/**
 * Reads short decimal numbers without making strings of them.
 *
 * <p>Up to 15 digits make a whole number that a double holds, and so is each power of ten up to
 * 10²²; their quotient or product is rounded once, so it is what an exact parser gives.
 */
final class Decimal {
    private static final int MOST_DIGITS = 15;
    private static final double[] POWERS = {
        1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15
    };

    private Decimal() {}

    /** The number from one place of a text up to another; NaN where it is none or a long one. */
    static double easy(CharSequence text, int from, int to) {
        int at = from;
        boolean negative = text.charAt(at) == '-';
        if (negative || text.charAt(at) == '+') at++;
        long digits = 0;
        int count = 0;
        int point = -1;
        for (; at < to; at++) {
            char c = text.charAt(at);
            if (c == '.' && point < 0) {
                point = count;
            } else if (c >= '0' && c <= '9' && count < MOST_DIGITS) {
                digits = 10 * digits + (c - '0');
                count++;
            } else {
                return Double.NaN;
            }
        }
        if (count == 0) return Double.NaN;
        double value = point < 0 ? digits : digits / POWERS[count - point];
        return negative ? -value : value;
    }
}
