package rasterlab.engine.visibility.buffer;

import java.util.concurrent.atomic.AtomicReference;

/** The buffer of the last frame, for the next one of the same size; safe to use by many threads. */
final class SpareDepths {
    /** A larger buffer is not kept between frames, in pixels: a screen of 3840×2160 fits. */
    private static final int LARGEST_KEPT = 1 << 23;

    private final AtomicReference<int[]> spare = new AtomicReference<>(new int[0]);

    /** Hands out a buffer that may still hold the depths of another frame. */
    int[] take(int pixels) {
        int[] last = spare.getAndSet(new int[0]);
        return last.length == pixels ? last : new int[pixels];
    }

    /** Keeps a buffer that nobody reads any more. */
    void giveBack(int[] buffer) {
        if (buffer.length <= LARGEST_KEPT) spare.set(buffer);
    }
}
