package rasterlab.engine.visibility.depth;

import java.util.Arrays;
import rasterlab.contract.DepthFormat;

/**
 * What a depth buffer makes of {@link DepthRows}, surface after surface, pixel after pixel.
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
        DepthFormat.Codes coder = format.over(rows.range());
        int pixels = rows.pixels();
        var codes = new int[rows.count()];
        var row = new int[pixels];
        for (int s = 0; s < rows.surfaces(); s++) {
            coder.row(rows.nearness(s), rows.perPixel(s), 0, pixels, row);
            System.arraycopy(row, 0, codes, s * pixels, pixels);
            checkLaterStart(coder, rows, s, codes);
        }
        return new StoredDepths(
                pixels, codes, Arrays.stream(codes).mapToDouble(coder::depth).toArray());
    }

    /**
     * Puts the codes of a row that starts in the middle where they mean other depths than those of
     * the whole row. Methods that add up along a row differ by less than {@link #SAME}.
     */
    private static void checkLaterStart(
            DepthFormat.Codes coder, DepthRows rows, int surface, int[] codes) {
        int from = rows.pixels() / 2;
        // Longer than needed, as the contract allows.
        var later = new int[rows.pixels()];
        coder.row(rows.nearness(surface), rows.perPixel(surface), from, rows.pixels(), later);
        for (int i = from; i < rows.pixels(); i++) {
            int at = surface * rows.pixels() + i;
            double whole = coder.depth(codes[at]);
            double part = coder.depth(later[i - from]);
            if (!(whole == part || Math.abs(part / whole - 1) <= SAME)) codes[at] = later[i - from];
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
