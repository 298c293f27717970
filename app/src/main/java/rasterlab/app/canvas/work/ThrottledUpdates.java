package rasterlab.app.canvas.work;

import java.time.Duration;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Passes news on, but not more often than the eye follows; those in between are never made.
 *
 * @param <T> the news
 */
public final class ThrottledUpdates<T> {
    private final Consumer<Runnable> tell;
    private final Duration between;
    private final Consumer<T> heard;
    private long next = System.nanoTime();

    /**
     * @param tell runs what it is given where the news are heard
     * @param between the least time from one to the next
     */
    public ThrottledUpdates(Consumer<Runnable> tell, Duration between, Consumer<T> heard) {
        this.tell = tell;
        this.between = between;
        this.heard = heard;
    }

    /** Makes the news and passes them on, if it is time. */
    public void accept(Supplier<T> news) {
        if (System.nanoTime() < next) return;
        next = System.nanoTime() + between.toNanos();
        T now = news.get();
        tell.accept(() -> heard.accept(now));
    }
}
