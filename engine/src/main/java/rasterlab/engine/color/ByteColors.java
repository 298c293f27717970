package rasterlab.engine.color;

import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;

/**
 * Every number in a byte, as pictures and many libraries keep them: shares in 255ths, hues in
 * 256ths of a turn.
 *
 * <p>Source: A. R. Smith, Color gamut transform pairs, SIGGRAPH 1978, pp. 12–19; A. V. Kazantsev,
 * Foundations of computer graphics for programmers, Kazan, 2005, ch. 7, the RGB cube.
 */
final class ByteColors implements ColorConverter {
    private final ColorConverter formula = new FormulaColors();

    @Override
    public double[] convert(ColorModel from, double[] components, ColorModel to) {
        Components.require(from, components);
        return stored(formula.convert(from, stored(components, from), to), to);
    }

    private static double[] stored(double[] components, ColorModel model) {
        var stored = new double[components.length];
        for (int i = 0; i < stored.length; i++)
            stored[i] =
                    model.isHue(i)
                            ? Math.rint(components[i] / 360 * 256) % 256 * 360 / 256
                            : share(components[i], full(model, i));
        if (model.saturation() >= 0 && stored[model.saturation()] == 0) stored[0] = Double.NaN;
        return stored;
    }

    private static double share(double value, double full) {
        return Math.rint(value / full * Levels.HIGHEST) / Levels.HIGHEST * full;
    }

    private static double full(ColorModel model, int index) {
        if (model != ColorModel.HVS) return 1;
        return index == 1 ? Math.sqrt(3) : Math.sqrt(2 / 3.0);
    }
}
