package rasterlab.contract;

/**
 * Writes a colour of one model in another.
 *
 * <p>The answer is the usual one of all that mean the colour: a grey's hue is NaN and its
 * saturation 0, black has no other inks, of three inks beside black one is 0, hues are from 0 to
 * below 360. From a model to itself the same holds: a colour that is written otherwise comes out as
 * the usual one. A number may be off by 16·2⁻⁵³, or by what an exercise allows, a hue by as much as
 * moves the colour by that.
 */
@FunctionalInterface
public interface ColorConverter {
    /**
     * The colour in the other model.
     *
     * @param from the model of {@code components}
     * @param components as many numbers as the model has, each in its range; a hue may be from 0 to
     *     360, and is not looked at where the saturation is 0 (it may be NaN there)
     * @param to the model of the answer; may be the same one
     * @return a new array
     * @throws IllegalArgumentException if a number is out of its range or the colour outside the
     *     colour cube; the message names the component, its value and the range
     */
    double[] convert(ColorModel from, double[] components, ColorModel to);
}
