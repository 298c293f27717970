package rasterlab.engine.color;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import rasterlab.contract.ColorModel;

/**
 * Colours in all models.
 *
 * @param models of each model the numbers of all colours, one after the other
 */
public record ColorSheet(Map<ColorModel, double[]> models) {
    public ColorSheet {
        models = Collections.unmodifiableMap(new EnumMap<>(models));
    }

    /** The numbers of one model. */
    public double[] in(ColorModel model) {
        return models.get(model);
    }

    int count() {
        return in(ColorModel.RGB).length / ColorModel.RGB.size();
    }
}
