package rasterlab.engine.color;

import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;

/** Every model by way of red, green and blue. */
public final class FormulaColors implements ColorConverter {
    @Override
    public double[] convert(ColorModel from, double[] components, ColorModel to) {
        Components.require(from, components);
        return fromRgb(toRgb(from, components), to);
    }

    static double[] toRgb(ColorModel from, double[] components) {
        return switch (from) {
            case RGB -> components;
            case CMY -> Inks.cmyToRgb(components);
            case CMYK -> Inks.cmykToRgb(components);
            case HSV -> Hexcone.toRgb(components);
            case HVS -> GreyDiagonal.toRgb(components);
        };
    }

    private static double[] fromRgb(double[] rgb, ColorModel to) {
        return switch (to) {
            case RGB -> rgb.clone();
            case CMY -> Inks.cmyFromRgb(rgb);
            case CMYK -> Inks.cmykFromRgb(rgb);
            case HSV -> Hexcone.fromRgb(rgb);
            case HVS -> GreyDiagonal.fromRgb(rgb);
        };
    }
}
