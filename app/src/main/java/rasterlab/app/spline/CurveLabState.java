package rasterlab.app.spline;

import rasterlab.app.spline.curve.CurveAt;
import rasterlab.engine.range.Bounds;

/**
 * The state that the lab shows at one moment.
 *
 * @param choice the newest one
 * @param drawings the newest finished ones, maybe of an earlier choice
 * @param t where the construction is shown, in [0, 1] over all curves
 * @param at what is at t of the drawings' curves
 * @param step the last of the drawing's points whose t is not beyond; 0 where there is none
 * @param arrangement changes when the stage should show the whole curve again
 */
public record CurveLabState(
        CurveChoice choice,
        CurveDrawings drawings,
        double t,
        CurveAt at,
        int step,
        int arrangement) {
    public CurveLabState {
        Bounds.require("t", t, 0, 1);
    }

    /** The drawing of the chosen method. */
    public CurveDrawing drawing() {
        return drawings.drawing();
    }
}
