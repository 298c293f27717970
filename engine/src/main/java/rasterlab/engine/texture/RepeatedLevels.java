package rasterlab.engine.texture;

/**
 * The levels of a texture that is repeated both ways and whose sides are powers of two: many
 * lookups in a loop, in whole numbers.
 *
 * <p>Indices are wrapped by masks. Where the nearest texel is wanted, colours are those of {@link
 * TextureSampler}'s single lookups; where texels are mixed, a coordinate's fraction is a whole
 * number of steps of 2⁻²², the nearest, so colours may differ from those by a level or two. Beyond
 * ±2²² the place is any one.
 */
final class RepeatedLevels {
    private static final int PARTS = TexelLoops.PARTS;

    private final ThreadLocal<TexelBlock> blocks = ThreadLocal.withInitial(TexelBlock::new);
    private final RepeatedLevel[] levels;

    RepeatedLevels(Texture texture) {
        levels = new RepeatedLevel[texture.levelCount()];
        for (int k = 0; k < levels.length; k++) levels[k] = RepeatedLevel.of(texture.level(k));
    }

    static boolean fits(Texture texture, Wrap alongS, Wrap alongT) {
        return alongS == Wrap.REPEAT
                && alongT == Wrap.REPEAT
                && Integer.bitCount(texture.width()) == 1
                && Integer.bitCount(texture.height()) == 1;
    }

    void nearest(int count, float[] s, float[] t, int[] texel) {
        TexelLoops.nearest(levels[0], s, t, texel, 0, count);
    }

    void linear(int count, float[] s, float[] t, int[] texel) {
        TexelBlock block = blocks.get();
        for (int from = 0; from < count; from += TexelBlock.SIZE) {
            int n = Math.min(TexelBlock.SIZE, count - from);
            TexelLoops.gather(levels[0], s, t, from, 0, n, block.fine());
            block.mix(n, false, texel, from);
        }
    }

    void trilinear(int count, float[] s, float[] t, float[] squaredStep, int[] texel) {
        TexelBlock block = blocks.get();
        for (int from = 0; from < count; from += TexelBlock.SIZE) {
            int n = Math.min(TexelBlock.SIZE, count - from);
            TexelLoops.levels(n, squaredStep, from, levels.length - 1 << PARTS, block.lambda);
            boolean two = gather(n, s, t, from, block);
            block.mix(n, two, texel, from);
        }
    }

    /**
     * Looks up what is around n places in the levels of their λ and the next ones, and says whether
     * any λ is between two levels. Neighbours mostly have the same levels.
     */
    private boolean gather(int n, float[] s, float[] t, int from, TexelBlock block) {
        int[] lambda = block.lambda;
        int between = 0;
        for (int first = 0, end; first < n; first = end) {
            int level = lambda[first] >> PARTS;
            int parts = 0;
            for (end = first; end < n && lambda[end] >> PARTS == level; end++)
                parts |= lambda[end] & TexelLoops.WHOLE - 1;
            between |= parts;
            TexelLoops.gather(levels[level], s, t, from, first, end, block.fine());
            // The last level's next is itself; mixed with share 0 it may be anything.
            if (parts != 0)
                TexelLoops.gather(levels[level + 1], s, t, from, first, end, block.coarse());
        }
        return between != 0;
    }
}
