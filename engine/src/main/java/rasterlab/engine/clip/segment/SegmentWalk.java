package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * A segment on its way through a window, one cut or one test per step.
 *
 * <p>Drain it with {@code while (walk.advance())}, then {@link #send} what is left.
 */
public interface SegmentWalk {
    /** Makes the next step; false when there is none, and then again each time. */
    boolean advance();

    /** The thing that the last step looked at, in a word: a side of the window, an end. */
    String at();

    /**
     * The number the last step decided by; see {@link SteppedSegmentClipper#decisionFormula}. Not a
     * number where there is none.
     */
    double decision();

    /** Sends the part not yet cut off, rounded, as it is after the last step. */
    void piece(SegmentSink out);

    /** Divisions of doubles made so far. */
    int divisions();

    /** Whether doubles could not decide, so that {@link #send} computes without rounding. */
    boolean unsure();

    /** Sends what is left of the segment, if anything, once {@link #advance} has returned false. */
    void send(SegmentSink out);
}
