package rasterlab.engine.texture;

import java.util.Optional;

/**
 * Looks colours up in a texture; allocates nothing, safe to use from several threads.
 *
 * <p>Linear filters mix texels in 256ths, each channel within 2 levels of the exact mean.
 */
public final class TextureSampler {
    /** Parts of a whole in which texels are mixed, as a power of two. */
    private static final int BITS = 8;

    private static final int WHOLE = 1 << BITS;

    private final Texture texture;
    private final Wrap alongS;
    private final Wrap alongT;
    private final TextureLevel[] levels;
    private final int highest;

    /** The faster ways to the levels, where there are any. */
    private final Optional<RepeatedLevels> repeated;

    public TextureSampler(Texture texture, Wrap alongS, Wrap alongT) {
        this.texture = texture;
        this.alongS = alongS;
        this.alongT = alongT;
        levels = new TextureLevel[texture.levelCount()];
        for (int i = 0; i < levels.length; i++) levels[i] = texture.level(i);
        highest = levels.length - 1;
        repeated =
                RepeatedLevels.fits(texture, alongS, alongT)
                        ? Optional.of(new RepeatedLevels(texture))
                        : Optional.empty();
    }

    public Texture texture() {
        return texture;
    }

    /** The texel that (s, t) lies in, of the picture itself. NaN is taken for 0. */
    public int nearest(double s, double t) {
        return nearest(levels[0], s, t);
    }

    private int nearest(TextureLevel level, double s, double t) {
        int i = Math.min(level.width() - 1, (int) (alongS.within(s) * level.width()));
        int j = Math.min(level.height() - 1, (int) (alongT.within(t) * level.height()));
        return level.texel(i, j);
    }

    /** The four texels around (s, t) mixed by how near their centres are. */
    public int linear(double s, double t) {
        return linear(levels[0], alongS.within(s), alongT.within(t));
    }

    /** u and v are places in 256ths of a texel, counted from the first texel's centre. */
    private int linear(TextureLevel level, double s, double t) {
        int width = level.width();
        int height = level.height();
        int u = (int) (s * width * WHOLE + 0.5) - WHOLE / 2;
        int v = (int) (t * height * WHOLE + 0.5) - WHOLE / 2;
        int i = u >> BITS;
        int j = v >> BITS;
        int right = u & WHOLE - 1;
        int above = v & WHOLE - 1;
        if (i < 0 || j < 0 || i + 1 >= width || j + 1 >= height)
            return atRim(level, i, j, right, above);
        return TexelMix.packed(
                TexelMix.of(
                        TexelMix.of(level.texel(i, j), level.texel(i + 1, j), right),
                        TexelMix.of(level.texel(i, j + 1), level.texel(i + 1, j + 1), right),
                        above));
    }

    private int atRim(TextureLevel level, int i, int j, int right, int above) {
        int i0 = alongS.index(i, level.width());
        int i1 = alongS.index(i + 1, level.width());
        int j0 = alongT.index(j, level.height());
        int j1 = alongT.index(j + 1, level.height());
        return TexelMix.packed(
                TexelMix.of(
                        TexelMix.of(texel(level, i0, j0), texel(level, i1, j0), right),
                        TexelMix.of(texel(level, i0, j1), texel(level, i1, j1), right),
                        above));
    }

    private static int texel(TextureLevel level, int i, int j) {
        return (i | j) < 0 ? 0 : level.texel(i, j);
    }

    /** {@link #nearest(double, double)} for many places. */
    public void nearest(int count, float[] s, float[] t, int[] texel) {
        if (repeated.isPresent()) repeated.get().nearest(count, s, t, texel);
        else for (int i = 0; i < count; i++) texel[i] = nearest(s[i], t[i]);
    }

    /** {@link #linear(double, double)} for many places. */
    public void linear(int count, float[] s, float[] t, int[] texel) {
        if (repeated.isPresent()) repeated.get().linear(count, s, t, texel);
        else for (int i = 0; i < count; i++) texel[i] = linear(s[i], t[i]);
    }

    /**
     * {@link #trilinear(double, double, double)} for many places.
     *
     * @param squaredStep ρ² of each, as {@link DetailLevel} computes it
     */
    public void trilinear(int count, float[] s, float[] t, float[] squaredStep, int[] texel) {
        if (repeated.isPresent()) repeated.get().trilinear(count, s, t, squaredStep, texel);
        else
            for (int i = 0; i < count; i++)
                texel[i] = trilinear(s[i], t[i], DetailLevel.quick(squaredStep[i]));
    }

    /** The nearest texel of the nearest level. */
    public int nearestLevel(double s, double t, double lambda) {
        return nearest(levels[(int) (within(lambda) + 0.5)], s, t);
    }

    /** The linear filter in the nearest level. */
    public int linearLevel(double s, double t, double lambda) {
        int level = (int) (within(lambda) + 0.5);
        return linear(levels[level], alongS.within(s), alongT.within(t));
    }

    /** The nearest texels of the two levels around λ, mixed by how near the levels are. */
    public int nearestBetween(double s, double t, double lambda) {
        double level = within(lambda);
        int finer = (int) level;
        int fine = nearest(levels[finer], s, t);
        if (finer == highest) return fine;
        int coarser = (int) ((level - finer) * WHOLE + 0.5);
        return TexelMix.packed(TexelMix.of(fine, nearest(levels[finer + 1], s, t), coarser));
    }

    /**
     * The linear filter in the two levels around λ, mixed by how near they are; the linear filter
     * alone for λ ≤ 0, where the picture is not made smaller.
     *
     * @param lambda as {@link DetailLevel} computes it; NaN is taken for 0
     */
    public int trilinear(double s, double t, double lambda) {
        double level = within(lambda);
        int finer = (int) level;
        int coarser = (int) ((level - finer) * WHOLE + 0.5);
        double ss = alongS.within(s);
        double tt = alongT.within(t);
        int fine = linear(levels[finer], ss, tt);
        if (coarser == 0 || finer == highest) return fine;
        return TexelMix.packed(TexelMix.of(fine, linear(levels[finer + 1], ss, tt), coarser));
    }

    private double within(double lambda) {
        return lambda > 0 ? Math.min(lambda, highest) : 0;
    }
}
