package rasterlab.app.canvas.player;

/** Something that a step player moves through. */
public interface Steps {
    /** The first step there is; equal to {@link #last} when there is nothing to play. */
    default int first() {
        return 0;
    }

    int last();

    /** Where it stands, in [first, last]. */
    int step();

    /** Goes to a step; one outside [first, last] goes to the nearer end. */
    void goTo(int step);

    /** The step nearest to that one, in [first, last]. */
    default int within(int step) {
        return Math.max(first(), Math.min(last(), step));
    }

    /** The step so many further on, or back: round and round, or to the nearer end at most. */
    default int after(int count) {
        int to = step() + count;
        if (!turnsRound()) return within(to);
        return first() + Math.floorMod(to - first(), last() - first() + 1);
    }

    /** Called when no other step follows at once: one was made alone, or playing has stopped. */
    default void rest() {}

    /** Whether the first step comes after the last. */
    default boolean turnsRound() {
        return false;
    }
}
