package rasterlab.engine.clip.polygon;

import rasterlab.contract.PolygonSink;

/**
 * A polygon on its way through a window.
 *
 * <p>Drain it with {@code while (walk.advance())}, then {@link #send} what is left.
 */
public interface PolygonWalk {
    /** Makes the next step; false when there is none, and then again each time. */
    boolean advance();

    /** The last step, in a few words. */
    String at();

    /** x and y of each corner of the polygon that the last step made or went on with. */
    double[] polygon();

    /**
     * Where the subject's boundary entered the window in the last step and where it left it: x0,
     * y0, x1, y1. Empty where the method does not look for such places.
     */
    double[] passage();

    /** How often it was asked on which side of a window's side a corner lies, so far. */
    long sideTests();

    /** Divisions of doubles made so far. */
    long divisions();

    /** Crossings computed without rounding so far. */
    long unroundedCrossings();

    /** Sends the pieces, once {@link #advance} has returned false. */
    void send(PolygonSink out);
}
