package rasterlab.app.visibility;

import java.util.ArrayDeque;
import java.util.Deque;

/** Times of the last pictures. */
final class FrameTimes {
    private static final int KEPT = 15;

    /** The first picture of a method is slow, whatever the method is. */
    private static final int ENOUGH = 3;

    private final Deque<Long> nanos = new ArrayDeque<>();

    void add(long time) {
        nanos.addLast(time);
        if (nanos.size() > KEPT) nanos.removeFirst();
    }

    void clear() {
        nanos.clear();
    }

    /** The middle one, the upper of two; 0 before there are {@value #ENOUGH}. */
    long median() {
        if (nanos.size() < ENOUGH) return 0;
        return nanos.stream().sorted().skip(nanos.size() / 2).findFirst().orElse(0L);
    }
}
