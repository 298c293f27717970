package rasterlab.engine.light;

import java.util.stream.IntStream;
import rasterlab.engine.color.Levels;

/**
 * Seeing one surface through another: I = I₁·α + I₂·(1 − α), I₁ and α being the nearer one's.
 *
 * <p>The rule is not symmetric, so surfaces must be laid one over the other from back to front: in
 * any other order the picture shows a different arrangement, not a rounding error.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 7.
 */
public final class Transparency {
    private Transparency() {}

    /** One channel of the nearer surface over what is behind it. */
    public static double over(double near, double alpha, double behind) {
        return near * alpha + behind * (1 - alpha);
    }

    /**
     * What is seen through surfaces given in any order.
     *
     * @param depths the distance of each surface from the eye; of equal ones the later is nearer
     * @param rgba four shares of each, one after the other
     * @param background three shares
     * @return three shares from 0 to 1
     */
    public static double[] seen(double[] depths, double[] rgba, double[] background) {
        if (rgba.length != 4 * depths.length)
            throw new IllegalArgumentException(
                    "%d depths need %d shares, got %d"
                            .formatted(depths.length, 4 * depths.length, rgba.length));
        double[] seen = background.clone();
        for (int layer : farToNear(depths))
            for (int c = 0; c < 3; c++)
                seen[c] = over(rgba[4 * layer + c], rgba[4 * layer + 3], seen[c]);
        for (int c = 0; c < 3; c++) seen[c] = Levels.cut(seen[c]);
        return seen;
    }

    /** The order in which to draw: indices of the farthest first, equal ones as they are given. */
    public static int[] farToNear(double[] depths) {
        for (int i = 0; i < depths.length; i++)
            if (Double.isNaN(depths[i]))
                throw new IllegalArgumentException("depths[" + i + "] must be a number, got NaN");
        return IntStream.range(0, depths.length)
                .boxed()
                .sorted((a, b) -> Double.compare(depths[b], depths[a]))
                .mapToInt(Integer::intValue)
                .toArray();
    }
}
