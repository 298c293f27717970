package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;

/**
 * The depths that share one code, found by bisecting the doubles between the planes.
 *
 * @param nearest the least double z with that code
 * @param farthest the greatest one
 */
public record DepthCell(double nearest, double farthest) {
    /**
     * The depths that cannot be told from {@code z}.
     *
     * @param z between the planes
     */
    public static DepthCell of(DepthCoding.RangeCodes codes, DepthRange range, double z) {
        double far = Math.min(range.far(), Double.MAX_VALUE);
        return new DepthCell(last(codes, z, range.near()), last(codes, z, far));
    }

    /**
     * The smallest distance at which something behind each surface is told apart from it, surface
     * after surface, pixel after pixel; NaN where nothing up to the far plane is.
     */
    public static double[] behind(DepthCoding format, DepthRows rows) {
        DepthRange range = rows.range();
        DepthCoding.RangeCodes codes = format.over(range);
        var behind = new double[rows.count()];
        for (int i = 0; i < behind.length; i++) {
            double z = rows.depth(i / rows.pixels(), i % rows.pixels());
            behind[i] = of(codes, range, z).behind(range, z);
        }
        return behind;
    }

    /** The double that is farthest from {@code z} on the way to {@code end} and has its code. */
    private static double last(DepthCoding.RangeCodes codes, double z, double end) {
        int code = codes.code(1 / z);
        if (codes.code(1 / end) == code) return end;
        long same = Double.doubleToRawLongBits(z);
        long other = Double.doubleToRawLongBits(end);
        while (Math.abs(other - same) > 1) {
            long middle = same + (other - same) / 2;
            if (codes.code(1 / Double.longBitsToDouble(middle)) == code) same = middle;
            else other = middle;
        }
        return Double.longBitsToDouble(same);
    }

    /**
     * The smallest distance at which a surface behind {@code z} is told apart from it.
     *
     * @param z one of the cell's depths
     * @return NaN where nothing up to the far plane is
     */
    public double behind(DepthRange range, double z) {
        double next = Math.nextUp(farthest);
        return next <= range.far() && farthest < Double.MAX_VALUE ? next - z : Double.NaN;
    }

    /** The distance at which any two surfaces here are told apart. */
    public double width() {
        return Math.nextUp(farthest) - nearest;
    }
}
