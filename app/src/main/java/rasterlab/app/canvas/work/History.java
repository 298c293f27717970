package rasterlab.app.canvas.work;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Earlier choices of the user, and those that were taken back; a drag counts as one change.
 *
 * @param <T> an immutable choice with {@code equals}
 */
public final class History<T> {
    private static final int REMEMBERED = 200;

    private final Deque<T> earlier = new ArrayDeque<>();
    private final Deque<T> takenBack = new ArrayDeque<>();
    private final Supplier<T> present;
    private final Consumer<T> show;
    private Optional<T> dragStart = Optional.empty();
    private long changes;

    /** Names of the stages on which something was done, for as long as the program runs. */
    private final Set<String> tried = new HashSet<>();

    /**
     * @param present the choice of this moment
     * @param show makes a choice the present one without {@link #remember}
     */
    public History(Supplier<T> present, Consumer<T> show) {
        this.present = present;
        this.show = show;
    }

    /** Remembers what is about to be changed, unless a drag is on; nothing can be redone then. */
    public void remember() {
        if (dragStart.isEmpty()) remember(present.get());
    }

    public void beginDrag() {
        if (dragStart.isEmpty()) dragStart = Optional.of(present.get());
    }

    /** Ends the drag; one that changed nothing is forgotten. */
    public void endDrag() {
        dragStart.filter(start -> !start.equals(present.get())).ifPresent(this::remember);
        dragStart = Optional.empty();
    }

    /** Counts all changes of that as one. */
    public void asOne(Runnable changes) {
        beginDrag();
        try {
            changes.run();
        } finally {
            endDrag();
        }
    }

    /** Whether something was done on the stage of that name. */
    public boolean isTried(String stage) {
        return tried.contains(stage);
    }

    /** Notes that something was done on the stage of that name, for panels that are made later. */
    public void tried(String stage) {
        tried.add(stage);
    }

    /** How often something was changed, undone or redone: another number after each time. */
    public long changes() {
        return changes;
    }

    public boolean undoable() {
        return !earlier.isEmpty() || dragStart.isPresent();
    }

    public boolean redoable() {
        return !takenBack.isEmpty() && dragStart.isEmpty();
    }

    /** Takes back the newest change; within a drag, what was dragged so far. */
    public void undo() {
        step(earlier, takenBack);
    }

    /** Makes the change again that was taken back last. */
    public void redo() {
        step(takenBack, earlier);
    }

    /** Lets nothing be undone or redone any more. */
    public void forget() {
        earlier.clear();
        takenBack.clear();
        dragStart = dragStart.map(start -> present.get());
    }

    private void step(Deque<T> from, Deque<T> to) {
        boolean dragging = dragStart.isPresent();
        endDrag();
        if (!from.isEmpty()) {
            changes++;
            to.push(present.get());
            show.accept(from.pop());
        }
        if (dragging) beginDrag();
    }

    private void remember(T choice) {
        changes++;
        takenBack.clear();
        earlier.push(choice);
        if (earlier.size() > REMEMBERED) earlier.removeLast();
    }
}
