package rasterlab.contract;

/**
 * Finds the texture coordinates of a row of pixels.
 *
 * <p>Pixel i of n is the share f = i/(n − 1) along the row. On the screen s/depth, t/depth and
 * 1/depth are linear, s and t are not: s = ((1 − f)·s₀/d₀ + f·s₁/d₁)/((1 − f)/d₀ + f/d₁).
 */
@FunctionalInterface
public interface TextureMapper {
    /**
     * The coordinates.
     *
     * @return s, t of each pixel, one after the other
     */
    double[] coordinates(TexturedSpan span);
}
