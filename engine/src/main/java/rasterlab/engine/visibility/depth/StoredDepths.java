package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthFormat;

/**
 * The contents of a depth buffer after {@link DepthRows}, surface after surface, pixel after pixel.
 *
 * @param pixels of each surface
 * @param codes what the depth test compares; the smaller one is nearer
 * @param depths z that each code stands for
 */
public record StoredDepths(int pixels, int[] codes, double[] depths) {
    /** A share of a depth. */
    private static final double SAME = 0.25;

    /** Stores the rows in a format. */
    public static StoredDepths of(DepthFormat format, DepthRows rows) {
        int pixels = rows.pixels();
        var stored = new StoredDepths(pixels, new int[rows.count()], new double[rows.count()]);
        for (int s = 0; s < rows.surfaces(); s++) {
            Row whole = Row.of(format, rows, s, 0);
            System.arraycopy(whole.codes, 0, stored.codes, s * pixels, pixels);
            System.arraycopy(whole.depths, 0, stored.depths, s * pixels, pixels);
            stored.checkLaterStart(Row.of(format, rows, s, pixels / 2), s);
        }
        return stored;
    }

    /** A row of a surface from one of its pixels on. */
    private record Row(int from, int[] codes, double[] depths) {
        static Row of(DepthFormat format, DepthRows rows, int surface, int from) {
            // The arrays are longer than needed where the row starts later, as the contract allows.
            var row = new Row(from, new int[rows.pixels()], new double[rows.pixels()]);
            format.store(
                    rows.range(),
                    rows.nearness(surface),
                    rows.perPixel(surface),
                    from,
                    rows.pixels(),
                    row.codes,
                    row.depths);
            return row;
        }
    }

    /**
     * Puts the codes of a row that starts in the middle where they mean other depths than those of
     * the whole row. Methods that add up along a row differ by less than {@link #SAME}.
     */
    private void checkLaterStart(Row later, int surface) {
        for (int i = later.from; i < pixels; i++) {
            int at = surface * pixels + i;
            double whole = depths[at];
            double part = later.depths[i - later.from];
            if (whole == part || Math.abs(part / whole - 1) <= SAME) continue;
            codes[at] = later.codes[i - later.from];
            depths[at] = part;
        }
    }

    public int surfaces() {
        return codes.length / pixels;
    }

    /** The surface that a depth test leaves in a pixel: of equal codes the first. */
    public int front(int pixel) {
        int front = 0;
        for (int s = 1; s < surfaces(); s++)
            if (codes[s * pixels + pixel] < codes[front * pixels + pixel]) front = s;
        return front;
    }
}
