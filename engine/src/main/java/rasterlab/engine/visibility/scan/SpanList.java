package rasterlab.engine.visibility.scan;

import java.util.Arrays;

/** Spans of one row, in the order in which they are painted. */
final class SpanList {
    private int[] spans = new int[96];
    private int size;

    void clear() {
        size = 0;
    }

    int size() {
        return size;
    }

    /** Pixels [from, to) of a face that is named by its place. */
    void add(int place, int from, int to) {
        if (3 * size == spans.length) spans = Arrays.copyOf(spans, 2 * spans.length);
        spans[3 * size] = place;
        spans[3 * size + 1] = from;
        spans[3 * size + 2] = to;
        size++;
    }

    int place(int span) {
        return spans[3 * span];
    }

    int from(int span) {
        return spans[3 * span + 1];
    }

    int to(int span) {
        return spans[3 * span + 2];
    }
}
