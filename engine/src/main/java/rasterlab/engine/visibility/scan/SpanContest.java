package rasterlab.engine.visibility.scan;

import java.util.Arrays;
import rasterlab.engine.visibility.Tally;

/**
 * Which of several faces is seen where, along pixels of a row that all of them own.
 *
 * <p>Nearness is linear along the row, so a face that is the nearest of all at both ends is so in
 * between. Where two different ones are, the span is split at the pixel at which the planes of
 * these two cross.
 */
final class SpanContest {
    private final ScreenFaces faces;
    private final Tally tally;
    private int[] places = new int[16];
    private int[] layers = new int[16];
    private int[] before = new int[16];
    private int size;
    private boolean seenThrough;

    SpanContest(ScreenFaces faces, Tally tally) {
        this.faces = faces;
        this.tally = tally;
    }

    void clear() {
        size = 0;
        seenThrough = false;
    }

    void add(int place) {
        if (size == places.length) places = Arrays.copyOf(places, 2 * size);
        places[size++] = place;
        seenThrough |= !faces.opaque(place);
    }

    /** Adds what is seen in the pixels [from, to), back to front where it is seen through. */
    void resolve(int row, int from, int to, SpanList out) {
        if (size == 0) return;
        if (size == 1) out.add(places[0], from, to);
        else if (seenThrough) resolveLayers(row, from, to, out);
        else resolveOpaque(row, from, to, out);
    }

    private void resolveOpaque(int row, int from, int to, SpanList out) {
        int first = nearest(row, from);
        int last = to - from == 1 ? first : nearest(row, to - 1);
        if (first == last) {
            out.add(first, from, to);
            return;
        }
        tally.splits++;
        int crossing = crossing(first, last, row, from, to);
        resolveOpaque(row, from, crossing, out);
        resolveOpaque(row, crossing, to, out);
    }

    private int nearest(int row, int x) {
        tally.depthTests += size;
        int best = places[0];
        for (int i = 1; i < size; i++) if (faces.nearer(places[i], best, x, row)) best = places[i];
        return best;
    }

    /** The first pixel where {@code last} is nearer, found by halving; not {@code from}. */
    private int crossing(int first, int last, int row, int from, int to) {
        int still = from;
        int beyond = to - 1;
        while (beyond - still > 1) {
            int middle = still + beyond >>> 1;
            tally.depthTests += 2;
            if (faces.nearer(last, first, middle, row)) beyond = middle;
            else still = middle;
        }
        return beyond;
    }

    /** Decides pixel by pixel; runs of pixels with the same layers are painted together. */
    private void resolveLayers(int row, int from, int to, SpanList out) {
        if (layers.length < size) {
            layers = new int[2 * size];
            before = new int[2 * size];
        }
        int begin = from;
        int count = layers(row, from);
        for (int x = from + 1; x <= to; x++) {
            int[] swap = before;
            before = layers;
            layers = swap;
            int here = x < to ? layers(row, x) : -1;
            if (here == count && sameLayers(count)) continue;
            for (int i = count - 1; i >= 0; i--) out.add(before[i], begin, x);
            begin = x;
            count = here;
        }
    }

    private boolean sameLayers(int count) {
        for (int i = 0; i < count; i++) if (layers[i] != before[i]) return false;
        return true;
    }

    /** Puts into {@code layers} what is seen at a pixel, the nearest first, an opaque one last. */
    private int layers(int row, int x) {
        tally.depthTests += size;
        int count = 0;
        for (int i = 0; i < size; i++) {
            int at = count;
            while (at > 0 && faces.nearer(places[i], layers[at - 1], x, row)) at--;
            if (at > 0 && faces.opaque(layers[at - 1])) continue;
            for (int k = count; k > at; k--) layers[k] = layers[k - 1];
            layers[at] = places[i];
            count = faces.opaque(places[i]) ? at + 1 : count + 1;
        }
        return count;
    }
}
