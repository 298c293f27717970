package rasterlab.engine.transform;

import java.util.ArrayList;
import java.util.List;

/**
 * The "amount of perspective" γ: how many times larger the nearer of two equal depths appears.
 *
 * <p>Two segments of depth dz' follow each other along the line of sight, the nearer one from z' to
 * z' + dz'. Their images, of points at one height, have the ratio γ = 1 + 2·dz'/z'. It does not
 * depend on the picture plane's distance d, which only scales. Below z' = 2 to 3 dz' it runs away.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "simple
 * perspective transformation".
 */
public final class PerspectiveAmount {
    private PerspectiveAmount() {}

    /** One point of the chart. */
    public record PerspectiveSample(double distance, double gamma) {}

    /**
     * @param distance z' of the nearer segment's near end, above 0
     * @param depth dz' of each segment, at least 0
     */
    public static double gamma(double distance, double depth) {
        requireAbove("distance", distance);
        if (!(depth >= 0 && depth < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "depth must be a finite number from 0, got " + depth);
        return 1 + 2 * (depth / distance);
    }

    /**
     * The chart of γ over z' in units of dz', evenly spaced.
     *
     * @param from smallest z'/dz', above 0
     * @param to largest
     * @param count of samples, at least 2
     */
    public static List<PerspectiveSample> chart(double from, double to, int count) {
        requireAbove("from", from);
        if (!(to > from && to < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "to must be a finite number above from, " + from + ", got " + to);
        if (count < 2) throw new IllegalArgumentException("count must be at least 2, got " + count);
        var samples = new ArrayList<PerspectiveSample>();
        for (int i = 0; i < count; i++) {
            double z = from + (to - from) * i / (count - 1);
            samples.add(new PerspectiveSample(z, gamma(z, 1)));
        }
        return samples;
    }

    private static void requireAbove(String name, double value) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    name + " must be a finite number above 0, got " + value);
    }
}
