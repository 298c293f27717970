package rasterlab.engine.texture;

/**
 * Texels around some hundred places, in one or two levels of a texture, and how they are mixed.
 *
 * <p>Texels are gathered one by one; they are mixed two channels of 16 bits in each number. One per
 * thread.
 */
final class TexelBlock {
    /** The most places: all arrays together stay in the first-level cache. */
    static final int SIZE = 256;

    /** λ in 256ths: its lowest eight bits say how near the coarser level is. */
    final int[] lambda = new int[SIZE];

    private final TexelCorners fine = new TexelCorners();
    private final TexelCorners coarse = new TexelCorners();

    /** Four texels around each place, and the place among them in 256ths. */
    static final class TexelCorners {
        final int[] leftBelow = new int[SIZE];
        final int[] rightBelow = new int[SIZE];
        final int[] leftAbove = new int[SIZE];
        final int[] rightAbove = new int[SIZE];
        final int[] toRight = new int[SIZE];
        final int[] up = new int[SIZE];
        final int[] other = new int[SIZE];
    }

    /** The level itself, or the finer one of two. */
    TexelCorners fine() {
        return fine;
    }

    TexelCorners coarse() {
        return coarse;
    }

    /** Colours 0xAARRGGBB of n places from one level, or from two. */
    void mix(int n, boolean two, int[] argb, int at) {
        TexelLoops.mix(n, fine);
        if (two) {
            TexelLoops.mix(n, coarse);
            TexelLoops.mixLevels(n, fine, coarse, lambda);
        }
        for (int i = 0; i < n; i++) argb[at + i] = fine.leftBelow[i] | fine.rightBelow[i] << 8;
    }
}
