package rasterlab.app.line;

import java.awt.Rectangle;
import rasterlab.app.canvas.PixelGrid;
import rasterlab.engine.line.Segment;

/** Chooses which part of the pixel grid the stage shows when the user has not zoomed. */
final class LineFraming {
    /** Pixels around the segment, so that a wrong pixel beside it is seen. */
    private static final int MARGIN = 3;

    /** Pixels shown at least, so that a single point does not fill the stage. */
    private static final int LEAST = 14;

    /** Of a segment too long to draw, this many pixels around end A are shown. */
    private static final int NEIGHBOURHOOD = 24;

    private LineFraming() {}

    /**
     * @param view where the grid may lie, in view units
     */
    static PixelGrid of(LineLabState state, Rectangle view) {
        Segment segment = state.choice().segment();
        return PixelGrid.fitting(
                segment.steps() < LineDrawing.LIMIT ? whole(segment) : beginning(segment), view);
    }

    private static Rectangle whole(Segment segment) {
        int left = Math.min(segment.x0(), segment.x1());
        int top = Math.min(segment.y0(), segment.y1());
        int width = Math.max(segment.x0(), segment.x1()) - left + 1;
        int height = Math.max(segment.y0(), segment.y1()) - top + 1;
        int marginX = Math.max(MARGIN, (LEAST - width + 1) / 2);
        int marginY = Math.max(MARGIN, (LEAST - height + 1) / 2);
        return new Rectangle(
                left - marginX, top - marginY, width + 2 * marginX, height + 2 * marginY);
    }

    private static Rectangle beginning(Segment segment) {
        return new Rectangle(
                segment.x0() - NEIGHBOURHOOD / 2,
                segment.y0() - NEIGHBOURHOOD / 2,
                NEIGHBOURHOOD,
                NEIGHBOURHOOD);
    }
}
