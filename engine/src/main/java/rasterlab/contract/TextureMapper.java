package rasterlab.contract;

/**
 * Finds the texture coordinates of a row of pixels.
 *
 * <p>Pixel i of n is the share f = i/(n − 1) along the row. On the screen s/depth, t/depth and
 * 1/depth are linear, s and t are not: s = ((1 − f)·s₀/d₀ + f·s₁/d₁)/((1 − f)/d₀ + f/d₁). So the
 * first pixel has the first coordinates and the last one the last; a single pixel has f = 0.
 */
@FunctionalInterface
public interface TextureMapper {
    /**
     * The coordinates, each of which may be off by 10⁻⁹ of a texel of a picture of 256×256. No span
     * may be refused.
     *
     * @return s, t of each pixel, one after the other, in a new array
     */
    double[] coordinates(TexturedSpan span);
}
