package rasterlab.tests.bench.pipeline;

import java.util.Locale;
import rasterlab.tests.bench.language.BenchWords;

/**
 * How far two pictures are apart.
 *
 * @param off pixels with a channel off by more than two levels
 * @param one pixels with a channel off by one or two levels
 * @param pixels of a picture
 */
record Difference(int off, int one, int pixels) {
    static Difference of(int[] ours, int[] theirs) {
        int off = 0;
        int one = 0;
        for (int i = 0; i < ours.length; i++) {
            int most = 0;
            for (int shift = 0; shift < 24; shift += 8)
                most =
                        Math.max(
                                most,
                                Math.abs((ours[i] >> shift & 255) - (theirs[i] >> shift & 255)));
            if (most > 2) off++;
            else if (most > 0) one++;
        }
        return new Difference(off, one, ours.length);
    }

    String text(BenchWords words) {
        return words.text(
                "note.difference",
                String.valueOf(off),
                String.format(Locale.ROOT, "%.4f", 100.0 * off / pixels),
                String.format(Locale.ROOT, "%.2f", 100.0 * one / pixels));
    }
}
