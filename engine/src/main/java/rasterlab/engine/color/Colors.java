package rasterlab.engine.color;

import java.util.Arrays;
import rasterlab.contract.ColorModel;

/**
 * Colours written in one model.
 *
 * @param model what the numbers are
 * @param components colour after colour
 */
public record Colors(ColorModel model, double[] components) {
    public Colors {
        if (components.length == 0 || components.length % model.size() != 0)
            throw new IllegalArgumentException(
                    "%s needs %d numbers for each colour, got %d in all"
                            .formatted(model.code(), model.size(), components.length));
        components = components.clone();
    }

    /** One colour. */
    public static Colors of(ColorModel model, double... components) {
        return new Colors(model, components);
    }

    public int count() {
        return components.length / model.size();
    }

    /** The numbers of colour {@code index}. */
    double[] color(int index) {
        return Arrays.copyOfRange(components, index * model.size(), (index + 1) * model.size());
    }

    @Override
    public String toString() {
        return model.code() + Arrays.toString(components);
    }
}
