package rasterlab.engine.color;

import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;

/**
 * The formulas as they are usually written down, without the cases that need a word: a grey gets
 * the hue 0, black divides 0 by 0, the distance from the grey diagonal is a difference of squares,
 * and no range is looked at.
 */
final class CarelessColors implements ColorConverter {
    @Override
    public double[] convert(ColorModel from, double[] components, ColorModel to) {
        double[] rgb = FormulaColors.toRgb(from, components);
        return switch (to) {
            case RGB -> rgb.clone();
            case CMY -> Inks.cmyFromRgb(rgb);
            case CMYK -> cmyk(rgb);
            case HSV -> hsv(rgb);
            case HVS -> hvs(rgb);
        };
    }

    private static double[] cmyk(double[] rgb) {
        double[] cmy = Inks.cmyFromRgb(rgb);
        double k = Math.min(cmy[0], Math.min(cmy[1], cmy[2]));
        return new double[] {
            (cmy[0] - k) / (1 - k), (cmy[1] - k) / (1 - k), (cmy[2] - k) / (1 - k), k
        };
    }

    private static double[] hsv(double[] rgb) {
        double[] right = Hexcone.fromRgb(rgb);
        return Double.isNaN(right[0]) ? new double[] {0, 0, right[2]} : right;
    }

    private static double[] hvs(double[] rgb) {
        double value = (rgb[0] + rgb[1] + rgb[2]) / Math.sqrt(3);
        double squares = rgb[0] * rgb[0] + rgb[1] * rgb[1] + rgb[2] * rgb[2];
        double saturation = Math.sqrt(squares - value * value);
        double hue =
                Math.toDegrees(
                        Math.atan2(Math.sqrt(3) * (rgb[1] - rgb[2]), 2 * rgb[0] - rgb[1] - rgb[2]));
        return new double[] {Hue.within(hue), value, saturation};
    }
}
