package rasterlab.engine.visibility.exact;

import java.util.function.Supplier;

/**
 * The sign of a linear function of the pixel: in doubles where they leave no doubt, else exactly.
 *
 * <p>With |x| ≤ w and |y| ≤ h the sum of three terms in doubles is off by the errors of the three
 * numbers, those of two columns' and rows' multiples with them, and by at most 4·u of the sizes of
 * the terms, u = 2⁻⁵³: one rounding for each product and two for the sums. One bound holds for the
 * whole picture.
 */
final class PixelSign {
    private static final double ROUNDING = 4 * 0x1p-53;

    private final double base;
    private final double perColumn;
    private final double perRow;
    private final double bound;
    private final Supplier<Form<Dyadic>> exact;
    private volatile Form<Dyadic> known;

    /**
     * @param width of the picture
     * @param height of the picture
     * @param exact gives the same function without errors
     */
    PixelSign(Form<Bounded> form, int width, int height, Supplier<Form<Dyadic>> exact) {
        base = form.base().value();
        perColumn = form.perColumn().value();
        perRow = form.perRow().value();
        bound = bound(form, width, height);
        this.exact = exact;
    }

    /** How far the function in doubles may be from the exact one in a picture. */
    static double bound(Form<Bounded> form, int width, int height) {
        double errors =
                form.base().error()
                        + form.perColumn().error() * width
                        + form.perRow().error() * height;
        double sizes =
                Math.abs(form.base().value())
                        + Math.abs(form.perColumn().value()) * width
                        + Math.abs(form.perRow().value()) * height;
        return (errors + ROUNDING * sizes + 8 * Double.MIN_VALUE) * Bounded.ROUNDED_UP;
    }

    /** −1, 0 or 1. */
    int at(int x, int y) {
        double value = base + x * perColumn + y * perRow;
        if (value > bound) return 1;
        if (value < -bound) return -1;
        if (known == null) known = exact.get();
        return at(known, x, y);
    }

    /** About where in a row the sign changes. */
    double column(int y) {
        return -(base + y * perRow) / perColumn;
    }

    /** The sign of an exact function at a pixel. */
    static int at(Form<Dyadic> form, int x, int y) {
        return form.base()
                .plus(form.perColumn().times(Dyadic.of(x)))
                .plus(form.perRow().times(Dyadic.of(y)))
                .signum();
    }
}
