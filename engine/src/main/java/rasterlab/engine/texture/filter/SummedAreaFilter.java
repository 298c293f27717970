package rasterlab.engine.texture.filter;

/**
 * The mean over a footprint with sides along the picture's, from a table of sums: entry (i, j) is
 * the sum of all texels below and left of it, so a rectangle's sum takes four of them.
 *
 * <p>Sums of parts of texels are found by mixing entries, which is exact since a texel has one
 * colour. Sums are whole numbers up to 255·2²⁶ and exact in double.
 *
 * <p>Source: F. C. Crow, Summed-area tables for texture mapping, SIGGRAPH 1984, pp. 207–212.
 */
final class SummedAreaFilter implements PreparedFilter {
    private static final int CHANNELS = 4;

    @Override
    public Lookup prepare(int width, int height, int[] argb) {
        var sums = new double[(width + 1) * (height + 1) * CHANNELS];
        int row = (width + 1) * CHANNELS;
        for (int j = 0; j < height; j++)
            for (int i = 0; i < width; i++)
                for (int c = 0; c < CHANNELS; c++) {
                    int at = (j + 1) * row + (i + 1) * CHANNELS + c;
                    int level = argb[j * width + i] >>> 8 * c & 255;
                    sums[at] =
                            level
                                    + sums[at - CHANNELS]
                                    + sums[at - row]
                                    - sums[at - row - CHANNELS];
                }
        return (s, t, dsdx, dtdx, dsdy, dtdy) -> {
            if (dtdx != 0 || dsdy != 0)
                throw new IllegalArgumentException(
                        "footprint must not be turned: dt/dx and ds/dy must be 0, got %s and %s"
                                .formatted(dtdx, dsdy));
            if (Footprint.isPoint(dsdx, dtdx, dsdy, dtdy, width, height))
                return texel(width, height, argb, s, t);
            double wide = Math.abs(dsdx * width);
            double high = Math.abs(dtdy * height);
            return mean(
                    new Sums(width, height, sums),
                    wide < SMALLEST ? widened(s, width, wide) : s * width,
                    high < SMALLEST ? widened(t, height, high) : t * height,
                    Math.max(SMALLEST, wide),
                    Math.max(SMALLEST, high));
        };
    }

    /** A narrower footprint is made that wide, in texels, or its sums would lose their digits. */
    private static final double SMALLEST = 1e-6;

    /**
     * The middle of a footprint that is made as wide as {@link #SMALLEST} and shows the same: away
     * from the next border between texels in the same proportion, or in the middle of its texel.
     */
    private static double widened(double middle, int size, double wide) {
        double u = size * middle;
        double border = Math.rint(u);
        double beyond = u - border + Math.fma(size, middle, -u);
        return Math.abs(beyond) < wide / 2
                ? border + beyond * (SMALLEST / wide)
                : border + Math.copySign(0.5, beyond);
    }

    private static int texel(int width, int height, int[] argb, double s, double t) {
        int i = Math.floorMod((int) Math.floor(s * width), width);
        int j = Math.floorMod((int) Math.floor(t * height), height);
        return argb[j * width + i];
    }

    private static int mean(Sums sums, double u, double v, double wide, double high) {
        int argb = 0;
        for (int c = CHANNELS - 1; c >= 0; c--) {
            double right = u + wide / 2;
            double left = u - wide / 2;
            double upper = v + high / 2;
            double lower = v - high / 2;
            double sum =
                    sums.below(right, upper, c)
                            - sums.below(left, upper, c)
                            - sums.below(right, lower, c)
                            + sums.below(left, lower, c);
            int level = (int) (sum / (wide * high) + 0.5);
            argb = argb << 8 | Math.max(0, Math.min(255, level));
        }
        return argb;
    }

    /** The table, and the picture's repetitions around it. */
    private record Sums(int width, int height, double[] table) {
        /** The sum of the texels from (0, 0) to (u, v), negative to the left or below. */
        double below(double u, double v, int c) {
            double turnsU = Math.floor(u / width);
            double turnsV = Math.floor(v / height);
            double restU = u - turnsU * width;
            double restV = v - turnsV * height;
            double whole = within(width, height, c);
            return turnsU * turnsV * whole
                    + turnsU * within(width, restV, c)
                    + turnsV * within(restU, height, c)
                    + within(restU, restV, c);
        }

        private double within(double u, double v, int c) {
            int i = (int) Math.min(u, width - 1);
            int j = (int) Math.min(v, height - 1);
            double right = u - i;
            double above = v - j;
            return (1 - above) * ((1 - right) * entry(i, j, c) + right * entry(i + 1, j, c))
                    + above * ((1 - right) * entry(i, j + 1, c) + right * entry(i + 1, j + 1, c));
        }

        private double entry(int i, int j, int c) {
            return table[(j * (width + 1) + i) * CHANNELS + c];
        }
    }
}
