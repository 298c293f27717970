package rasterlab.app.shell.labs;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;

/**
 * Holds work for another thread back until it is let go, in order: what is being made can hand out
 * work whose thread has to wait until it is whole.
 */
final class HeldEvents implements Executor {
    private final Executor events;
    private List<Runnable> held = new ArrayList<>();
    private boolean letGo;

    /**
     * @param events runs what it is given on one thread, in order
     */
    HeldEvents(Executor events) {
        this.events = events;
    }

    @Override
    public synchronized void execute(Runnable work) {
        if (letGo) events.execute(work);
        else held.add(work);
    }

    /** Passes on what was held, and from now on everything at once. */
    synchronized void letGo() {
        letGo = true;
        held.forEach(events::execute);
        held = List.of();
    }
}
