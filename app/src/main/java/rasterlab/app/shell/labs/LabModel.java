package rasterlab.app.shell.labs;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import rasterlab.app.canvas.file.Kept;

/**
 * The model of one lab, made when it is first asked for, on the thread that asks; others that ask
 * meanwhile wait.
 *
 * @param <M> the model
 */
final class LabModel<M> implements AutoCloseable {
    private final Function<Executor, M> making;
    private final BiConsumer<M, Map<String, Kept<?>>> parts;
    private final Consumer<M> closing;
    private final Consumer<Map<String, Kept<?>>> begun;
    private final Executor events;
    private final List<Consumer<M>> waiting = new ArrayList<>();
    private volatile Optional<M> made = Optional.empty();
    private volatile boolean closed;

    /**
     * @param making given what runs the model's work for the event thread, once the model is made
     * @param parts puts what is kept of the model into a map, by the names under which it is kept
     * @param closing ends the model's background work
     * @param events runs what it is given on one thread, in order
     * @param begun told the kept parts of a model that nobody has seen yet
     */
    LabModel(
            Function<Executor, M> making,
            BiConsumer<M, Map<String, Kept<?>>> parts,
            Consumer<M> closing,
            Executor events,
            Consumer<Map<String, Kept<?>>> begun) {
        this.making = making;
        this.parts = parts;
        this.closing = closing;
        this.begun = begun;
        this.events = events;
    }

    /**
     * The model; the same one every time.
     *
     * @throws IllegalStateException if it was closed before it was made
     */
    M get() {
        return made.orElseGet(this::make);
    }

    private synchronized M make() {
        if (made.isPresent()) return made.get();
        if (closed) throw new IllegalStateException("the lab is closed");
        // Each model has its own queue: one that fails takes its events with it.
        var held = new HeldEvents(events);
        M model = making.apply(held);
        begun.accept(kept(model));
        waiting.forEach(each -> each.accept(model));
        made = Optional.of(model);
        held.letGo();
        return model;
    }

    /** Makes it before it is asked for, unless it is closed. */
    synchronized void prepare() {
        if (!closed) get();
    }

    /** The lab's model, or empty while it is not made. */
    Optional<M> ifMade() {
        return made;
    }

    /**
     * The kept parts of the model, by the names under which they are kept; none of a model that is
     * not made.
     */
    Map<String, Kept<?>> kept() {
        return made.map(this::kept).orElseGet(Map::of);
    }

    private Map<String, Kept<?>> kept(M model) {
        var kept = new LinkedHashMap<String, Kept<?>>();
        parts.accept(model, kept);
        return kept;
    }

    /** Does it with the model as soon as that is made, before anybody is given it. */
    synchronized void whenMade(Consumer<M> use) {
        made.ifPresentOrElse(use, () -> waiting.add(use));
    }

    /** Is not made from now on, without waiting for one that is being made. */
    void giveUp() {
        closed = true;
    }

    /** Ends its background work; one that is not made stays so. */
    @Override
    public synchronized void close() {
        closed = true;
        made.ifPresent(closing);
    }
}
