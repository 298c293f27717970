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

    /** Whether playing goes on at the first step after the last. */
    boolean turnsRound();
}
