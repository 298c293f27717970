package rasterlab.engine.visibility.painter;

import java.util.Optional;
import rasterlab.engine.visibility.VisibilityWalk;

/** A walk that draws pieces of faces. */
public interface PiecesWalk extends VisibilityWalk {
    /**
     * The corners of the piece that the last step drew, in pixels: x and y of each; empty where it
     * drew a whole face or nothing.
     */
    Optional<double[]> piece();
}
