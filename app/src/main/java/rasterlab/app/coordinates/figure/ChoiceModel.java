package rasterlab.app.coordinates.figure;

import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.work.Arranged;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.Listeners;

/**
 * A choice that can be changed, undone and taken back to how it was first; listeners are told each
 * new one.
 *
 * @param <C> an immutable choice with {@code equals}
 */
public abstract class ChoiceModel<C> implements Kept<C> {
    private final C first;
    private final History<Arranged<C>> history = new History<>(this::present, this::bring);
    private final Listeners<C> listeners = new Listeners<>();
    private C choice;
    private int arrangement;

    /** Arrangements so far; one that undo brings back is no new one. */
    private int arrangements;

    protected ChoiceModel(C first) {
        this.first = first;
        choice = first;
    }

    public final C choice() {
        return choice;
    }

    /** A number that is new whenever the stage should show everything again. */
    public final int arrangement() {
        return arrangement;
    }

    /** Tells the listener each new choice from now on; the answer ends that. */
    public final Runnable listen(Consumer<C> listener) {
        return listeners.add(listener);
    }

    /**
     * Changes the choice; all changes between {@link #beginDrag} and {@link #endDrag} are one for
     * undo.
     */
    public final void change(C next) {
        if (next.equals(choice)) return;
        history.remember();
        show(next);
    }

    /** Changes to a choice that looks so different that all of it should come into sight. */
    public final void rearrange(C next) {
        boolean same = next.equals(choice);
        if (!same) history.remember();
        arrangement = ++arrangements;
        if (!same) show(next);
    }

    /** Shows a choice that undo passes over, such as another step of the same scene. */
    protected final void pass(C next) {
        if (!next.equals(choice)) show(next);
    }

    public final void beginDrag() {
        history.beginDrag();
    }

    public final void endDrag() {
        history.endDrag();
        tell();
    }

    private Arranged<C> present() {
        return new Arranged<>(choice, arrangement);
    }

    private void bring(Arranged<C> earlier) {
        arrangement = earlier.arrangement();
        show(earlier.choice());
    }

    /** The choices that can be undone and redone. */
    public final History<?> history() {
        return history;
    }

    /** Returns to how the lab opens; can be undone. */
    public final void reset() {
        rearrange(first);
    }

    @Override
    @SuppressWarnings("unchecked")
    public final Class<C> keptType() {
        return (Class<C>) first.getClass();
    }

    @Override
    public final C kept() {
        return choice;
    }

    @Override
    public final void restore(C kept) {
        C before = choice;
        try {
            bring(new Arranged<>(kept, ++arrangements));
        } catch (RuntimeException e) {
            show(before);
            throw e;
        }
    }

    private void show(C next) {
        choice = next;
        chosen(next);
        tell();
    }

    /** Is told each new choice before the listeners are. */
    protected void chosen(C next) {}

    /** Tells the listeners the present choice once more. */
    protected final void tell() {
        listeners.tell(choice);
    }
}
