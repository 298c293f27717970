package rasterlab.exercises.searching;

/** Receives the progress of a search, on the thread that searches. */
public interface SearchListener {
    /** Tells how many inputs were tried so far, every now and then. */
    void tried(long inputs);

    /** Tells the first input that fails. */
    void found(Find find);

    /** Tells a simpler one that fails too. */
    void simpler(Find find);
}
