package rasterlab.app.canvas;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * Earlier choices of the user, newest first; a drag counts as one change.
 *
 * @param <T> an immutable choice with {@code equals}
 */
public final class History<T> {
    private static final int REMEMBERED = 200;

    private final Deque<T> earlier = new ArrayDeque<>();
    private boolean dragging;

    /** Remembers what is about to be changed, unless a drag is on. */
    public void remember(T choice) {
        if (dragging) return;
        earlier.push(choice);
        if (earlier.size() > REMEMBERED) earlier.removeLast();
    }

    public void beginDrag(T choice) {
        remember(choice);
        dragging = true;
    }

    /** Ends the drag; one that changed nothing is forgotten. */
    public void endDrag(T choice) {
        if (dragging && choice.equals(earlier.peek())) earlier.pop();
        dragging = false;
    }

    public boolean isEmpty() {
        return earlier.isEmpty();
    }

    /** Takes back the newest change: the choice before it. */
    public Optional<T> undo() {
        return Optional.ofNullable(earlier.poll());
    }
}
