package rasterlab.app.line.figure;

import rasterlab.app.line.trace.LineTrace;

/** Judges what a method drew of a figure. */
public final class RightFigure {
    private RightFigure() {}

    /** Whether it is what the exact figure is. */
    public static boolean is(FigureDrawing drawing) {
        return drawing.ending() == LineTrace.TraceEnding.ENDED
                && drawing.judged()
                && drawing.deviation().exact();
    }
}
