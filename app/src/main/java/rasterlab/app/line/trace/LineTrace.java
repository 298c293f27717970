package rasterlab.app.line.trace;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.WindowedLineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.LineWalk;
import rasterlab.engine.line.Segment;
import rasterlab.engine.line.SteppedLine;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.LimitReached;

/**
 * The steps of one method on one segment, in order; of a segment with a window, those inside.
 *
 * @param pixels every pixel that was lit, in order
 * @param decisions the decision variable at each pixel; empty when the method does not show it
 * @param decides which pixel a decision is about, where there are any
 * @param message what the method said when it refused or crashed; else empty
 */
public record LineTrace(
        PixelRecording pixels,
        List<Double> decisions,
        SteppedLine.Decides decides,
        TraceEnding ending,
        String message) {
    /** How the drawing came to its end. */
    public enum TraceEnding {
        /** The method reached its own end. */
        ENDED,
        /** The figure has more pixels than the lab draws. */
        CUT,
        /** The method went on although the segment had ended. */
        ENDLESS,
        /** The method said that it cannot draw this segment. */
        REFUSED,
        /** The method failed. */
        CRASHED;

        /** Whether there is an answer, of which it can be told how right it is. */
        public boolean answered() {
            return this == ENDED || this == CUT;
        }
    }

    public LineTrace {
        decisions = List.copyOf(decisions);
    }

    /**
     * @param limit the most pixels to draw
     */
    public static LineTrace of(LineRasterizer method, Segment segment, int limit) {
        var pixels = new PixelRecording(limit);
        var decisions = new ArrayList<Double>();
        try {
            if (method instanceof SteppedLine stepped) walk(stepped, segment, pixels, decisions);
            else draw(method, segment, pixels);
            return ended(method, pixels, decisions, TraceEnding.ENDED, "");
        } catch (LimitReached e) {
            boolean longer = segment.steps() >= limit;
            TraceEnding ending = longer ? TraceEnding.CUT : TraceEnding.ENDLESS;
            return ended(method, pixels, decisions, ending, e.getMessage());
        } catch (IllegalArgumentException e) {
            return ended(method, pixels, decisions, TraceEnding.REFUSED, e.getMessage());
        } catch (RuntimeException e) {
            return ended(method, pixels, decisions, TraceEnding.CRASHED, e.toString());
        }
    }

    private static LineTrace ended(
            LineRasterizer method,
            PixelRecording pixels,
            List<Double> decisions,
            TraceEnding ending,
            String message) {
        SteppedLine.Decides decides =
                method instanceof SteppedLine stepped
                        ? stepped.decides()
                        : SteppedLine.Decides.NEXT_PIXEL;
        return new LineTrace(pixels, decisions, decides, ending, message);
    }

    private static void draw(LineRasterizer method, Segment segment, PixelRecording pixels) {
        if (method instanceof WindowedLineRasterizer windowed) draw(windowed, segment, pixels);
        else
            method.draw(
                    segment.x0(),
                    segment.y0(),
                    segment.x1(),
                    segment.y1(),
                    (x, y) -> {
                        if (segment.window().contains(x, y)) pixels.plot(x, y);
                    });
    }

    /** A whole segment is drawn in a window that is just large enough for it. */
    private static void draw(WindowedLineRasterizer method, Segment s, PixelRecording pixels) {
        PixelWindow window = s.isWhole() ? around(s) : s.window();
        method.draw(
                s.x0(),
                s.y0(),
                s.x1(),
                s.y1(),
                window.xmin(),
                window.ymin(),
                window.xmax(),
                window.ymax(),
                pixels);
    }

    private static PixelWindow around(Segment s) {
        return new PixelWindow(
                Math.min(s.x0(), s.x1()),
                Math.min(s.y0(), s.y1()),
                Math.max(s.x0(), s.x1()),
                Math.max(s.y0(), s.y1()));
    }

    private static void walk(
            SteppedLine method, Segment segment, PixelRecording pixels, List<Double> decisions) {
        LineWalk walk = LineTopic.walk(method, segment);
        while (walk.advance()) {
            pixels.plot(walk.x(), walk.y());
            decisions.add(walk.decision());
        }
    }
}
