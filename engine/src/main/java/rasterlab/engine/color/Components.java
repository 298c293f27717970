package rasterlab.engine.color;

import java.util.Locale;
import rasterlab.contract.ColorModel;

/** The ranges of a colour's numbers. */
final class Components {
    private Components() {}

    /** Whether {@link #require} lets the number pass, a hue that is not looked at aside. */
    static boolean inRange(ColorModel model, int index, double value) {
        return value >= 0 && value <= model.highest(index);
    }

    /**
     * @throws IllegalArgumentException naming the first number that is out of its range
     */
    static void require(ColorModel model, double[] components) {
        if (components.length != model.size())
            throw new IllegalArgumentException(
                    "%s has %d numbers, got %d"
                            .formatted(model.code(), model.size(), components.length));
        boolean gray = model.saturation() >= 0 && components[model.saturation()] == 0;
        for (int i = 0; i < components.length; i++)
            if (!(gray && model.isHue(i)) && !inRange(model, i, components[i]))
                throw new IllegalArgumentException(
                        "%s %s must be from 0 to %s, got %s"
                                .formatted(
                                        model.code(),
                                        model.component(i),
                                        written(model.highest(i)),
                                        components[i]));
    }

    private static String written(double highest) {
        return highest == Math.rint(highest)
                ? "" + (int) highest
                : String.format(Locale.ROOT, "%.4f", highest);
    }
}
