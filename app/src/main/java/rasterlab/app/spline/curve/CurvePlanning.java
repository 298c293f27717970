package rasterlab.app.spline.curve;

import rasterlab.engine.range.Bounds;

/**
 * The user's wishes for the plan of a curve.
 *
 * @param on whether the plan chooses the method
 * @param times that the polyline is drawn, from 1 to {@value #MOST_TIMES}
 */
public record CurvePlanning(boolean on, int times) {
    public static final int MOST_TIMES = 10_000;

    /**
     * The wishes at first: one drawing for each frame of a second, by the method that is chosen.
     */
    public static final CurvePlanning FIRST = new CurvePlanning(false, 60);

    public CurvePlanning {
        Bounds.require("times", times, 1, MOST_TIMES);
    }

    public CurvePlanning with(boolean chosen) {
        return new CurvePlanning(chosen, times);
    }

    public CurvePlanning with(int drawn) {
        return new CurvePlanning(on, drawn);
    }
}
