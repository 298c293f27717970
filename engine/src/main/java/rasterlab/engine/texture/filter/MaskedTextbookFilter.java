package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.engine.texture.TexelShare;

/**
 * The texel as it is looked up in many programs: {@code texture[(int) (t·height) & (height − 1)]
 * [(int) (s·width) & (width − 1)]}.
 *
 * <p>A cast cuts towards 0, so that left of 0 and below it every texel is taken for its neighbour;
 * the mask repeats the picture only where its sides are powers of two.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch.
 * 15, which asks for sides that are powers of two.
 */
final class MaskedTextbookFilter implements SteppedFilter {
    @Override
    public Lookup prepare(int width, int height, int[] argb) {
        return (s, t, dsdx, dtdx, dsdy, dtdy) -> argb[masked(t, height) * width + masked(s, width)];
    }

    @Override
    public Trace trace(int width, int height, int[] argb) {
        return (s, t, dsdx, dtdx, dsdy, dtdy) -> {
            int i = masked(s, width);
            int j = masked(t, height);
            return List.of(new TexelShare(0, i, j, 1, argb[j * width + i]));
        };
    }

    private static int masked(double place, int size) {
        return (int) (place * size) & size - 1;
    }
}
