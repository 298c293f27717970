package rasterlab.app.visibility;

import java.util.ArrayDeque;
import java.util.Deque;

/** Times of the last pictures. */
final class FrameTimes {
    private static final int KEPT = 15;

    private final Deque<Long> nanos = new ArrayDeque<>();

    void add(long time) {
        nanos.addLast(time);
        if (nanos.size() > KEPT) nanos.removeFirst();
    }

    void clear() {
        nanos.clear();
    }

    /** The middle one, the upper of two; 0 when there is none. */
    long median() {
        return nanos.stream().sorted().skip(nanos.size() / 2).findFirst().orElse(0L);
    }
}
