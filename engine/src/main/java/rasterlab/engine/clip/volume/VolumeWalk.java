package rasterlab.engine.clip.volume;

import rasterlab.contract.SpaceSegmentSink;

/**
 * A segment on its way through the view volume, one plane per step.
 *
 * <p>Drain it with {@code while (walk.advance())}, then {@link #send} what is left.
 */
public interface VolumeWalk {
    /** Makes the next step; false when there is none, and then again each time. */
    boolean advance();

    /** The plane of the last step; empty before the first. */
    String at();

    /** The t of the last step, not a number where the plane is not met. */
    double decision();

    /** Sends the part not yet cut off, rounded, as it is after the last step. */
    void piece(SpaceSegmentSink out);

    /** Divisions of doubles made so far. */
    int divisions();

    /** Whether doubles cannot decide, so that {@link #send} computes without rounding. */
    boolean unsure();

    /** Sends what is left of the segment, if anything, once {@link #advance} has returned false. */
    void send(SpaceSegmentSink out);
}
