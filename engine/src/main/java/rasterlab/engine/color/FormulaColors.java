package rasterlab.engine.color;

import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;

/**
 * Every model by way of red, green and blue.
 *
 * <p>Source: A. R. Smith, Color gamut transform pairs, SIGGRAPH 1978, pp. 12–19; A. V. Kazantsev,
 * Foundations of computer graphics for programmers, Kazan, 2005, ch. 7, the RGB cube.
 */
public final class FormulaColors implements ColorConverter {
    /** Shares made of a darker value or a paler distance from grey would keep too few digits. */
    private static final double LEAST = 1e-300;

    @Override
    public double[] convert(ColorModel from, double[] components, ColorModel to) {
        Components.require(from, components);
        if (from == ColorModel.HSV) requireDigits(from, 2, components[2]);
        if (from == ColorModel.HVS) {
            requireDigits(from, 1, components[1]);
            requireDigits(from, 2, components[2]);
        }
        return fromRgb(toRgb(from, components), to);
    }

    private static void requireDigits(ColorModel model, int index, double value) {
        if (value != 0 && value < LEAST)
            throw new IllegalArgumentException(
                    "%s %s must be 0 or at least %s, got %s"
                            .formatted(model.code(), model.component(index), LEAST, value));
    }

    static double[] toRgb(ColorModel from, double[] components) {
        return switch (from) {
            case RGB -> components;
            case CMY -> Inks.cmyToRgb(components);
            case CMYK -> Inks.cmykToRgb(components);
            case HSV -> Hexcone.toRgb(components);
            case HVS -> GrayDiagonal.toRgb(components);
        };
    }

    private static double[] fromRgb(double[] rgb, ColorModel to) {
        return switch (to) {
            case RGB -> rgb.clone();
            case CMY -> Inks.cmyFromRgb(rgb);
            case CMYK -> Inks.cmykFromRgb(rgb);
            case HSV -> Hexcone.fromRgb(rgb);
            case HVS -> GrayDiagonal.fromRgb(rgb);
        };
    }
}
