package rasterlab.app.canvas;

/** Something that a step player moves through. */
public interface Steps {
    /** The first step there is; equal to {@link #last} when there is nothing to play. */
    int first();

    int last();

    /** Where it stands, in [first, last]. */
    int step();

    /** Goes to a step; one outside [first, last] goes to the nearer end. */
    void goTo(int step);

    /** The step nearest to that one, in [first, last]. */
    default int within(int step) {
        return Math.max(first(), Math.min(last(), step));
    }

    /** Told when no other step follows at once: one was made alone, or playing has stopped. */
    default void rest() {}

    /** Whether playing goes on at the first step after the last. */
    boolean turnsRound();
}
