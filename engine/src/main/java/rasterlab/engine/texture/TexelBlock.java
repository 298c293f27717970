package rasterlab.engine.texture;

/**
 * Texels around some hundred places, in one or two levels of a texture, and how they are mixed.
 *
 * <p>Texels are gathered one by one; they are mixed in loops so short that the compiler turns them
 * into vector instructions, two channels of 16 bits in each number, by {@link TexelMix}'s formula.
 * One per thread.
 */
final class TexelBlock {
    /** The most places: all arrays together stay in the first-level cache. */
    static final int SIZE = 256;

    private static final int WHOLE = 256;
    private static final int HALVES = 0x00800080;
    private static final int LEVELS = 0x00FF00FF;

    /** λ in 256ths: its lowest eight bits say how near the coarser level is. */
    final int[] lambda = new int[SIZE];

    private final int[] coarser = new int[SIZE];

    private final Corners fine = new Corners();
    private final Corners coarse = new Corners();

    /** Four texels around each place, and the place among them in 256ths. */
    static final class Corners {
        final int[] leftBelow = new int[SIZE];
        final int[] rightBelow = new int[SIZE];
        final int[] leftAbove = new int[SIZE];
        final int[] rightAbove = new int[SIZE];
        final int[] toRight = new int[SIZE];
        final int[] up = new int[SIZE];
        private final int[] other = new int[SIZE];

        /** Leaves red and blue in {@link #leftBelow}, alpha and green in {@link #rightBelow}. */
        private void mix(int n) {
            oddChannels(n, leftBelow, rightBelow, toRight, other);
            evenChannels(n, leftBelow, rightBelow, toRight);
            oddChannels(n, leftAbove, rightAbove, toRight, rightBelow);
            evenChannels(n, leftAbove, rightAbove, toRight);
            spread(n, leftBelow, leftAbove, up);
            spread(n, other, rightBelow, up);
            System.arraycopy(other, 0, rightBelow, 0, n);
        }
    }

    /** The level itself, or the finer one of two. */
    Corners fine() {
        return fine;
    }

    Corners coarse() {
        return coarse;
    }

    /** Colours 0xAARRGGBB of n places from one level, or from two. */
    void mix(int n, boolean two, int[] argb, int at) {
        fine.mix(n);
        if (two) {
            coarse.mix(n);
            for (int i = 0; i < n; i++) coarser[i] = lambda[i] & WHOLE - 1;
            spread(n, fine.leftBelow, coarse.leftBelow, coarser);
            spread(n, fine.rightBelow, coarse.rightBelow, coarser);
        }
        for (int i = 0; i < n; i++) argb[at + i] = fine.leftBelow[i] | fine.rightBelow[i] << 8;
    }

    /** Red and blue of two colours, into the first. */
    private static void evenChannels(int n, int[] a, int[] b, int[] share) {
        for (int i = 0; i < n; i++)
            a[i] =
                    (a[i] & LEVELS) * (WHOLE - share[i]) + (b[i] & LEVELS) * share[i] + HALVES >>> 8
                            & LEVELS;
    }

    /** Alpha and green of two colours. */
    private static void oddChannels(int n, int[] a, int[] b, int[] share, int[] out) {
        for (int i = 0; i < n; i++)
            out[i] =
                    (a[i] >>> 8 & LEVELS) * (WHOLE - share[i])
                                            + (b[i] >>> 8 & LEVELS) * share[i]
                                            + HALVES
                                    >>> 8
                            & LEVELS;
    }

    /** Two channels that stand 16 bits apart, into the first. */
    private static void spread(int n, int[] a, int[] b, int[] share) {
        for (int i = 0; i < n; i++)
            a[i] = a[i] * (WHOLE - share[i]) + b[i] * share[i] + HALVES >>> 8 & LEVELS;
    }
}
