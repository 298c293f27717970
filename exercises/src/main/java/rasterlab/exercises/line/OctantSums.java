package rasterlab.exercises.line;

import java.util.List;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.child.ItemSum;

/** Number and sum of the pixels of some lines, apart for each octant. */
final class OctantSums {
    /** Number of octants. */
    static final int OCTANTS = 8;

    private final long[] counts = new long[OCTANTS];
    private final long[] sums = new long[OCTANTS];

    private OctantSums() {}

    static OctantSums of(List<Segment> segments, LineVariation variation) {
        OctantSums all = new OctantSums();
        for (Segment one : segments) {
            ItemSum drawn = new ItemSum();
            variation.draw(one, drawn);
            all.counts[octant(one)] += drawn.count();
            all.sums[octant(one)] += drawn.sum();
        }
        return all;
    }

    /** From 0, by steepness and the signs of both differences. */
    static int octant(Segment s) {
        long dx = (long) s.x1() - s.x0();
        long dy = (long) s.y1() - s.y0();
        return (Math.abs(dy) > Math.abs(dx) ? 4 : 0) + (dx < 0 ? 2 : 0) + (dy < 0 ? 1 : 0);
    }

    long count() {
        return total(counts);
    }

    long sum() {
        return total(sums);
    }

    private static long total(long[] parts) {
        long total = 0;
        for (long one : parts) total += one;
        return total;
    }

    /** Whether these sums in some octants and the other ones in the rest come to that. */
    boolean mixedWith(OctantSums other, long count, long sum) {
        for (int some = 1; some < 1 << OCTANTS; some++) {
            long counted = 0;
            long summed = 0;
            for (int octant = 0; octant < OCTANTS; octant++) {
                OctantSums from = (some >> octant & 1) == 1 ? this : other;
                counted += from.counts[octant];
                summed += from.sums[octant];
            }
            if (counted == count && summed == sum) return true;
        }
        return false;
    }
}
