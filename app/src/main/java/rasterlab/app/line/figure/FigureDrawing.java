package rasterlab.app.line.figure;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.line.trace.ExtraWrites;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.circle.ArcWalk;
import rasterlab.engine.line.LineBrightness;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.LimitReached;

/**
 * The outcome of one method for a figure.
 *
 * @param message what it said when it refused or crashed, in English; "" otherwise
 * @param pixels in the order in which they were sent
 * @param judged whether there is an exact figure to hold the pixels against: not where it has too
 *     many
 * @param difference from the exact figure; none where nothing is judged
 * @param extra those sent that are not exact, or were sent before; none where nothing is judged
 * @param deviation from the exact figure; none where nothing is judged
 * @param decisions of the walk that the pixels mirror, by columns and rows from the centre
 * @param brightness light for a pixel of length at 0°, 1°, …, 90°, NaN where there is none; empty
 *     but for lines
 */
public record FigureDrawing(
        String method,
        LineTrace.TraceEnding ending,
        String message,
        PixelRecording pixels,
        boolean judged,
        PixelDifference difference,
        ExtraWrites extra,
        Deviation deviation,
        Map<RasterPoint, Double> decisions,
        List<Double> brightness) {
    /** A pen's figure and a chart have no pixels to step through. */
    private static final PixelRecording NO_PIXELS = new PixelRecording(1);

    private static final PixelDifference NO_DIFFERENCE = PixelDifference.of(NO_PIXELS, NO_PIXELS);

    static FigureDrawing of(FigureTopics topics, FigureScene scene, String method) {
        if (scene.figure() instanceof ArcFigure arc) return arc(topics, arc, method);
        List<Double> brightness =
                scene.mode() == LineMode.BRIGHTNESS ? brightness(topics, method) : List.of();
        return new FigureDrawing(
                method,
                LineTrace.TraceEnding.ENDED,
                "",
                NO_PIXELS,
                false,
                NO_DIFFERENCE,
                ExtraWrites.NONE,
                Deviation.NONE,
                Map.of(),
                brightness);
    }

    /** Light for a pixel of length at 0°, 1°, …, 90°, NaN where there is none. */
    static List<Double> brightness(FigureTopics topics, String method) {
        return IntStream.rangeClosed(0, SlopeFigure.STEEPEST)
                .mapToObj(degrees -> brightness(topics, method, SlopeFigure.segment(degrees)))
                .toList();
    }

    /** NaN where the method refuses the line or does not stop. */
    private static double brightness(FigureTopics topics, String method, Segment segment) {
        LineRasterizer drawing = topics.own().method(topics.line(), method).implementation();
        try {
            topics.line().record(drawing, segment, (int) (4 * segment.steps() + 4));
            return LineBrightness.of(drawing, segment).perPixel();
        } catch (LimitReached | IllegalArgumentException unfit) {
            return Double.NaN;
        }
    }

    private static FigureDrawing arc(FigureTopics topics, ArcFigure arc, String method) {
        Optional<PixelRecording> exact = exact(topics, arc);
        int right = exact.map(PixelRecording::size).orElse(topics.mostJudged());
        var pixels = new PixelRecording((int) topics.circle().mostBeforeEndless(right));
        var decisions = new HashMap<RasterPoint, Double>();
        LineTrace.TraceEnding ending = LineTrace.TraceEnding.ENDED;
        String message = "";
        try {
            topics.draw(arc, method, pixels);
            decisions(topics.walk(arc, method), right, decisions);
        } catch (LimitReached endless) {
            ending = exact.isEmpty() ? LineTrace.TraceEnding.CUT : LineTrace.TraceEnding.ENDLESS;
        } catch (IllegalArgumentException refused) {
            ending = LineTrace.TraceEnding.REFUSED;
            message = String.valueOf(refused.getMessage());
        } catch (RuntimeException crashed) {
            ending = LineTrace.TraceEnding.CRASHED;
            message = crashed.toString();
        }
        boolean refused = ending == LineTrace.TraceEnding.REFUSED;
        Optional<PixelRecording> wanted = refused ? Optional.of(pixels) : exact;
        Optional<PixelDifference> difference = wanted.map(all -> PixelDifference.of(all, pixels));
        return new FigureDrawing(
                method,
                ending,
                message,
                pixels,
                wanted.isPresent(),
                difference.orElse(NO_DIFFERENCE),
                difference.map(wrong -> ExtraWrites.of(wrong, pixels)).orElse(ExtraWrites.NONE),
                wanted.map(all -> topics.compare(arc, all, pixels)).orElse(Deviation.NONE),
                decisions,
                List.of());
    }

    /** A figure that leaves the range of int has no exact pixels. */
    private static Optional<PixelRecording> exact(FigureTopics topics, ArcFigure arc) {
        long right = (long) arc.centerX() + arc.radiusX();
        long bottom = (long) arc.centerY() + arc.radiusY();
        boolean drawn =
                arc.radiusX() >= 0
                        && arc.radiusY() >= 0
                        && right == (int) right
                        && bottom == (int) bottom
                        && (long) arc.centerX() - arc.radiusX() >= Integer.MIN_VALUE
                        && (long) arc.centerY() - arc.radiusY() >= Integer.MIN_VALUE;
        return drawn ? topics.exact(arc) : Optional.of(NO_PIXELS);
    }

    private static void decisions(
            Optional<ArcWalk> walk, int most, Map<RasterPoint, Double> decisions) {
        if (walk.isEmpty()) return;
        ArcWalk steps = walk.get();
        for (int i = 0; i <= most && steps.advance(); i++)
            decisions.putIfAbsent(new RasterPoint(steps.u(), steps.v()), steps.decision());
    }

    /** Whether the pixels are all that the method draws, so that they can be told apart. */
    boolean whole() {
        return ending != LineTrace.TraceEnding.REFUSED && ending != LineTrace.TraceEnding.CUT;
    }

    public int steps() {
        return pixels.size();
    }
}
