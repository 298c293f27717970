package rasterlab.app.line;

import java.awt.Rectangle;
import java.util.Optional;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Plotted;

/** Chooses which part of the pixel grid the stage shows when the user has not zoomed. */
final class LineFraming {
    /** Pixels around the segment and its window, so that a wrong pixel beside it is seen. */
    private static final int MARGIN = 3;

    /** Pixels shown at least, so that a single point does not fill the stage. */
    private static final int LEAST = 14;

    /** Pixels around end A that are shown of a segment too long to draw. */
    private static final int NEIGHBOURHOOD = 24;

    /** Pixels of a program are shown so far beside the segment, or as far as that is long. */
    private static final int BESIDE = 24;

    private LineFraming() {}

    /** The pixels to be seen. */
    static Rectangle of(LineLabState state) {
        Segment segment = state.choice().segment();
        if (segment.steps() >= LineDrawing.LIMIT) return beginning(segment);
        Optional<Plotted> plotted =
                state.drawings()
                        .tried()
                        .filter(program -> program.fits(state.choice()))
                        .flatMap(TrialSegment::drawn);
        return whole(segment, plotted);
    }

    private static Rectangle whole(Segment segment, Optional<Plotted> plotted) {
        Rectangle shown = pixels(segment.x0(), segment.y0(), segment.x1(), segment.y1());
        PixelWindow w = segment.window();
        if (!segment.isWhole()) shown.add(pixels(w.xmin(), w.ymin(), w.xmax(), w.ymax()));
        plotted.ifPresent(program -> addNear(shown, program.pixels()));
        shown.grow(
                Math.max(MARGIN, (LEAST - shown.width + 1) / 2),
                Math.max(MARGIN, (LEAST - shown.height + 1) / 2));
        return shown;
    }

    /** Adds the pixels that are near: those far away would leave nothing of the others. */
    private static void addNear(Rectangle shown, PixelRecording plotted) {
        var near = new Rectangle(shown);
        near.grow(Math.max(BESIDE, shown.width), Math.max(BESIDE, shown.height));
        for (int i = 0; i < plotted.size(); i++)
            if (near.contains(plotted.x(i), plotted.y(i)))
                shown.add(new Rectangle(plotted.x(i), plotted.y(i), 1, 1));
    }

    private static Rectangle pixels(int x0, int y0, int x1, int y1) {
        return new Rectangle(
                Math.min(x0, x1), Math.min(y0, y1), Math.abs(x1 - x0) + 1, Math.abs(y1 - y0) + 1);
    }

    private static Rectangle beginning(Segment segment) {
        return new Rectangle(
                segment.x0() - NEIGHBOURHOOD / 2,
                segment.y0() - NEIGHBOURHOOD / 2,
                NEIGHBOURHOOD,
                NEIGHBOURHOOD);
    }
}
