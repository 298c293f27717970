package rasterlab.app.polygon;

import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.outcome.PolygonResults;

/**
 * The lab at one moment: what its window shows.
 *
 * @param results of the chosen scene, or of one before it while it is worked on
 * @param step 0 before anything is done, then one step after another, at last the result
 * @param selected the point whose coordinates are shown
 * @param arrangement changes when the stage should show everything again
 */
public record PolygonLabState(
        PolygonChoice choice, PolygonResults results, int step, Grip selected, int arrangement) {
    /** Whether the result is shown. */
    public boolean finished() {
        return step > results.outcome().steps();
    }

    /** Whether a step is looked at. */
    boolean onAStep() {
        return step > 0 && !finished();
    }
}
