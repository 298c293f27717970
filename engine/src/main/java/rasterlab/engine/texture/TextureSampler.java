package rasterlab.engine.texture;

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

    public TextureSampler(Texture texture, Wrap alongS, Wrap alongT) {
        this.texture = texture;
        this.alongS = alongS;
        this.alongT = alongT;
        levels = new TextureLevel[texture.levelCount()];
        for (int i = 0; i < levels.length; i++) levels[i] = texture.level(i);
        highest = levels.length - 1;
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
        return mix(
                mix(level.texel(i, j), level.texel(i + 1, j), right),
                mix(level.texel(i, j + 1), level.texel(i + 1, j + 1), right),
                above);
    }

    private int atRim(TextureLevel level, int i, int j, int right, int above) {
        int i0 = alongS.index(i, level.width());
        int i1 = alongS.index(i + 1, level.width());
        int j0 = alongT.index(j, level.height());
        int j1 = alongT.index(j + 1, level.height());
        return mix(
                mix(texel(level, i0, j0), texel(level, i1, j0), right),
                mix(texel(level, i0, j1), texel(level, i1, j1), right),
                above);
    }

    private static int texel(TextureLevel level, int i, int j) {
        return (i | j) < 0 ? 0 : level.texel(i, j);
    }

    /** The nearest texel of the nearest level. */
    public int nearestLevel(double s, double t, double lambda) {
        return nearest(levels[(int) (within(lambda) + 0.5)], s, t);
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
        return mix(fine, linear(levels[finer + 1], ss, tt), coarser);
    }

    private double within(double lambda) {
        return lambda > 0 ? Math.min(lambda, highest) : 0;
    }

    /** (a·(256 − share) + b·share)/256 of each channel, rounded; two channels at a time. */
    private static int mix(int a, int b, int share) {
        int rest = WHOLE - share;
        int half = 0x00800080;
        int redBlue = (a & 0xFF00FF) * rest + (b & 0xFF00FF) * share + half >>> BITS & 0xFF00FF;
        int alphaGreen =
                (a >>> 8 & 0xFF00FF) * rest + (b >>> 8 & 0xFF00FF) * share + half & 0xFF00FF00;
        return alphaGreen | redBlue;
    }
}
