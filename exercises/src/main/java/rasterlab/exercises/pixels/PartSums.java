package rasterlab.exercises.pixels;

import java.util.List;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.child.ItemSum;

/** Number and sum of the pixels of some answers, apart for each part that drew their inputs. */
final class PartSums {
    private final long[] counts;
    private final long[] sums;

    private PartSums(int parts) {
        counts = new long[parts];
        sums = new long[parts];
    }

    /**
     * @param right the right answers
     * @param part of each, from 0
     * @param parts their number
     */
    static PartSums of(
            List<PixelRecording> right, int[] part, int parts, PixelVariation variation) {
        PartSums all = new PartSums(parts);
        for (int i = 0; i < part.length; i++) {
            ItemSum drawn = new ItemSum();
            variation.draw(right.get(i), drawn);
            all.counts[part[i]] += drawn.count();
            all.sums[part[i]] += drawn.sum();
        }
        return all;
    }

    long count() {
        return total(counts);
    }

    long sum() {
        return total(sums);
    }

    private static long total(long[] each) {
        long total = 0;
        for (long one : each) total += one;
        return total;
    }

    /** Whether these sums in some parts and the other ones in the rest come to that. */
    boolean mixedWith(PartSums other, long count, long sum) {
        for (int some = 1; some < 1 << counts.length; some++) {
            long counted = 0;
            long summed = 0;
            for (int part = 0; part < counts.length; part++) {
                PartSums from = (some >> part & 1) == 1 ? this : other;
                counted += from.counts[part];
                summed += from.sums[part];
            }
            if (counted == count && summed == sum) return true;
        }
        return false;
    }
}
