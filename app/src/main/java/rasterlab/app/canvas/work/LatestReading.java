package rasterlab.app.canvas.work;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Reads files on a thread of its own, and runs what the newest reading answers on the lab's. */
public final class LatestReading implements Consumer<Supplier<Runnable>>, Settling, AutoCloseable {
    private final LatestOnly<Supplier<Runnable>, Runnable> readings;

    /**
     * @param events runs what it is given on the lab's thread
     * @param onFailure told what reading threw that is no fault of a file, on any thread
     */
    public LatestReading(String threadName, Executor events, Consumer<Throwable> onFailure) {
        readings =
                new LatestOnly<>(
                        threadName,
                        (reading, cancelled) -> reading.get(),
                        (reading, answer) -> events.execute(answer),
                        onFailure);
    }

    @Override
    public void accept(Supplier<Runnable> reading) {
        readings.ask(reading);
    }

    @Override
    public void settle() throws InterruptedException {
        readings.settle();
    }

    @Override
    public void close() {
        readings.close();
    }
}
