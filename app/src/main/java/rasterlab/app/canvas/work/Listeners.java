package rasterlab.app.canvas.work;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * A list of those who are told of each change; all on one thread.
 *
 * @param <S> what they are told, such as a model's newest state
 */
public final class Listeners<S> {
    private final List<Consumer<S>> listeners = new ArrayList<>();

    /** Tells the listener from now on; the answer ends that. */
    public Runnable add(Consumer<S> listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    /** Tells all; who comes or goes meanwhile counts the next time. */
    public void tell(S news) {
        List.copyOf(listeners).forEach(listener -> listener.accept(news));
    }
}
