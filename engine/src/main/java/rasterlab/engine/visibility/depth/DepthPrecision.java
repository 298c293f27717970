package rasterlab.engine.visibility.depth;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.DepthFormat;
import rasterlab.contract.DepthRange;

/**
 * What formats tell apart half way to the far plane, over far/near: measured by search, and
 * predicted by formula.
 *
 * <p>With near = 1, z = far/2 and N = z·(1/near − 1/far) a distance is the share of z
 *
 * <ul>
 *   <li>N/2ⁿ where window depth has n bits, z·dw/dz being 1/N;
 *   <li>N·2ᵉ⁻²³ where it is a float from 2ᵉ up to 2ᵉ⁺¹;
 *   <li>(far − near)/(z·2ⁿ) where z itself has n bits.
 * </ul>
 *
 * Source of the first two: K. Akeley, J. Su, Minimum triangle separation for correct z-buffer
 * occlusion, 2006.
 */
public final class DepthPrecision {
    /** The formats, each with its own size of steps, in teaching order. */
    public static final List<String> FORMATS =
            List.of("z16", "z24", "z32", "zfloat", "reversed-z", "linear-16");

    /** The most that {@link #measured} can be, almost: the whole range, from near to far. */
    public static final double WHOLE_RANGE = 2;

    private static final double LEAST_RATIO = 10;
    private static final double MOST_RATIO = 1e9;

    private DepthPrecision() {}

    /**
     * One format at one ratio.
     *
     * @param ratio far/near
     * @param measured smallest distance that is certain to be told apart, as a share of z
     * @param predicted by the formula
     */
    public record Sample(String format, double ratio, double measured, double predicted) {}

    /** All formats at far/near = 10, 10^(1 + 1/perDecade), … 10⁹. */
    public static List<Sample> samples(int perDecade) {
        if (perDecade < 1)
            throw new IllegalArgumentException("perDecade must be at least 1, got " + perDecade);
        var samples = new ArrayList<Sample>();
        long steps = Math.round(Math.log10(MOST_RATIO / LEAST_RATIO) * perDecade);
        for (String format : FORMATS)
            for (int i = 0; i <= steps; i++) {
                double ratio = LEAST_RATIO * Math.pow(10, i / (double) perDecade);
                samples.add(
                        new Sample(
                                format, ratio, measured(format, ratio), predicted(format, ratio)));
            }
        return samples;
    }

    /** The width of the depths that share a code with z = far/2, as a share of z. */
    public static double measured(String format, double ratio) {
        var range = new DepthRange(1, ratio);
        DepthFormat.Codes codes =
                new DepthBufferTopic().method(format).implementation().over(range);
        return DepthCell.of(codes, range, ratio / 2).width() / (ratio / 2);
    }

    /** By the format's formula, which also goes beyond the whole range. */
    public static double predicted(String format, double ratio) {
        double perWindow = ratio / 2 * (1 - 1 / ratio);
        double window = (1 - 2 / ratio) / (1 - 1 / ratio);
        return switch (format) {
            case "z16" -> perWindow * 0x1p-16;
            case "z24" -> perWindow * 0x1p-24;
            case "z32" -> perWindow * 0x1p-32;
            case "zfloat" -> perWindow * Math.ulp(Math.min(Math.nextDown(1f), (float) window));
            case "reversed-z" -> perWindow * Math.ulp((float) (1 - window));
            case "linear-16" -> 2 * (1 - 1 / ratio) * 0x1p-16;
            default ->
                    throw new IllegalArgumentException(
                            "format must be one of " + FORMATS + ", got '" + format + "'");
        };
    }
}
