package rasterlab.engine.visibility.faces;

import java.util.Map;

/** Judges the faces of a body one after another. */
public interface FaceWalk {
    /** Judges the next face; false when all have been. */
    boolean advance();

    /** Number of the face judged last. */
    int face();

    boolean visible();

    /**
     * The value that the verdict was taken from; {@link SteppedVisibleFaces#decision} says what it
     * is.
     */
    double value();

    /** The operations so far: name in the plural to number. */
    Map<String, Long> operations();
}
