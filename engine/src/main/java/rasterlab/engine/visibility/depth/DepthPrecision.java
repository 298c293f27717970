package rasterlab.engine.visibility.depth;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.DepthRange;

/**
 * The smallest distance that formats tell apart half way to the far plane, over far/near: measured
 * by search, and predicted by formula.
 *
 * <p>With near = 1 and D = 1 − 1/far a window depth w is that of z = 1/(1 − w·D). A format that
 * stores w, or something linear in it, rounds all from w₀ to w₁ to one code: half a step to each
 * side of it, but not beyond the planes. So it tells apart what is the difference of z(w₁) and
 * z(w₀), and as long as a step is small, as a share of z = far/2 and with N = z·D,
 *
 * <ul>
 *   <li>N/2ⁿ where window depth has n bits, z·dw/dz being 1/N;
 *   <li>N·2ᵉ⁻²³ where it is a float from 2ᵉ up to 2ᵉ⁺¹;
 *   <li>(far − near)/(z·2ⁿ) where z itself has n bits.
 * </ul>
 *
 * Source of the first two: K. Akeley, J. Su, Minimum triangle separation for correct z-buffer
 * occlusion, 2006, pp. 27–30.
 */
public final class DepthPrecision {
    /** The formats, each with its own size of steps, in teaching order. */
    public static final List<String> FORMATS =
            List.of("z16", "z24", "z32", "zfloat", "reversed-z", "linear-16");

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
    public record PrecisionSample(String format, double ratio, double measured, double predicted) {}

    /** All formats at far/near = 10, 10^(1 + 1/perDecade), … 10⁹. */
    public static List<PrecisionSample> samples(int perDecade) {
        if (perDecade < 1)
            throw new IllegalArgumentException("perDecade must be at least 1, got " + perDecade);
        var samples = new ArrayList<PrecisionSample>();
        long steps = Math.round(Math.log10(MOST_RATIO / LEAST_RATIO) * perDecade);
        for (String format : FORMATS)
            for (int i = 0; i <= steps; i++) {
                double ratio = LEAST_RATIO * Math.pow(10, i / (double) perDecade);
                samples.add(
                        new PrecisionSample(
                                format, ratio, measured(format, ratio), predicted(format, ratio)));
            }
        return samples;
    }

    /** The width of the depths that share a code with z = far/2, as a share of z. */
    public static double measured(String format, double ratio) {
        var range = new DepthRange(1, ratio);
        var coding = (DepthCoding) new DepthBufferTopic().method(format).implementation();
        DepthCoding.RangeCodes codes = coding.over(range);
        return DepthCell.of(codes, range, ratio / 2).width() / (ratio / 2);
    }

    /** Error by the formula: z(w₁) − z(w₀), as a share of z. */
    public static double predicted(String format, double ratio) {
        double window = (1 - 2 / ratio) / (1 - 1 / ratio);
        double reversed = (1 / ratio) / (1 - 1 / ratio);
        double step =
                switch (format) {
                    case "z16" -> windowStep(Cell.ofBits(16, window), ratio);
                    case "z24" -> windowStep(Cell.ofBits(24, window), ratio);
                    case "z32" -> windowStep(Cell.ofBits(32, window), ratio);
                    case "zfloat" -> windowStep(Cell.ofFloat(window), ratio);
                    case "reversed-z" -> reversedStep(Cell.ofFloat(reversed), ratio);
                    case "linear-16" -> {
                        var cell = Cell.ofBits(16, (ratio / 2 - 1) / (ratio - 1));
                        yield (cell.to - cell.from) * (ratio - 1);
                    }
                    default ->
                            throw new IllegalArgumentException(
                                    "format must be one of " + FORMATS + ", got '" + format + "'");
                };
        return step / (ratio / 2);
    }

    /** z₁ − z₀ = (1/z₀ − 1/z₁)·z₀·z₁, which keeps its digits where the two are close. */
    private static double windowStep(Cell cell, double ratio) {
        double deep = 1 - 1 / ratio;
        double from = 1 / (1 - cell.from * deep);
        double to = 1 / (1 - cell.to * deep);
        return (cell.to - cell.from) * deep * from * to;
    }

    /** The step of 1 − w. */
    private static double reversedStep(Cell cell, double ratio) {
        double deep = 1 - 1 / ratio;
        double from = 1 / (1 / ratio + cell.to * deep);
        double to = 1 / (1 / ratio + cell.from * deep);
        return (cell.to - cell.from) * deep * from * to;
    }

    /** The interval that is rounded to one code, in shares of the whole range from 0 to 1. */
    private record Cell(double from, double to) {
        private Cell {
            from = Math.max(0, from);
            to = Math.min(1, to);
        }

        static Cell ofBits(int bits, double share) {
            double highest = Math.pow(2, bits) - 1;
            double code = Math.floor(share * highest + 0.5);
            return new Cell((code - 0.5) / highest, (code + 0.5) / highest);
        }

        static Cell ofFloat(double share) {
            float stored = (float) share;
            return new Cell(
                    ((double) Math.nextDown(stored) + stored) / 2,
                    ((double) stored + Math.nextUp(stored)) / 2);
        }
    }
}
