package rasterlab.app.line;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.contract.CoveragePixels;
import rasterlab.engine.line.CoverageLine;
import rasterlab.engine.line.LineWalk;
import rasterlab.engine.line.Segment;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.study.LimitReached;

/**
 * Pixels that a line covers in part, step by step; of a segment with a window, those of the steps
 * inside.
 *
 * @param shades in drawing order
 */
public record PixelCoverage(List<Shade> shades) {
    /** The error that a method may make by its rounding. */
    private static final int TOLERATED = 1;

    /**
     * @param step of the line's walk, counted from 1
     * @param level 1 to {@link CoverageLine#FULL}
     */
    public record Shade(int step, int x, int y, int level) {
        public Shade {
            Bounds.requireAtLeast("step", step, 1);
            Bounds.require("level", level, 1, CoverageLine.FULL);
        }
    }

    public PixelCoverage {
        shades = List.copyOf(shades);
    }

    /**
     * @param limit the most steps, at least 1
     * @throws IllegalArgumentException if the method refuses the segment
     */
    static PixelCoverage of(CoverageLine method, Segment s, int limit) {
        var collected = new Collected(method.walk(s.x0(), s.y0(), s.x1(), s.y1()), s, limit);
        try {
            method.shade(s.x0(), s.y0(), s.x1(), s.y1(), collected);
        } catch (LimitReached e) {
            return new PixelCoverage(collected.shades);
        }
        return new PixelCoverage(collected.shades);
    }

    /** Every pixel wholly, one a step. */
    static PixelCoverage whole(PixelRecording pixels) {
        return new PixelCoverage(
                IntStream.range(0, pixels.size())
                        .mapToObj(
                                i -> new Shade(i + 1, pixels.x(i), pixels.y(i), CoverageLine.FULL))
                        .toList());
    }

    /** Gives each pixel to the step of the walk that came last. */
    private static final class Collected implements CoveragePixels {
        private final List<Shade> shades = new ArrayList<>();
        private final LineWalk walk;
        private final Segment segment;
        private final int limit;
        private boolean going;
        private boolean inside;
        private int step;

        Collected(LineWalk walk, Segment segment, int limit) {
            this.walk = walk;
            this.segment = segment;
            this.limit = limit;
            going = walk.advance();
        }

        @Override
        public void plot(int x, int y, int level) {
            if (going && x == walk.x() && y == walk.y()) {
                inside = segment.window().contains(x, y);
                if (inside && step++ == limit) throw new LimitReached(limit, shades);
                going = walk.advance();
            }
            if (inside && segment.window().contains(x, y)) shades.add(new Shade(step, x, y, level));
        }
    }

    /**
     * The exact coverage: f being the signed distance across from the nearest pixel to the line, in
     * pixels, that pixel is covered by 1 − |f| and its neighbour on f's side by |f|, in levels
     * ⌈255·|f| − ½⌉ for the neighbour, at most 127.
     *
     * @param nearest the nearest pixels, in order; no farther than 2²⁸ steps from the beginning
     */
    static PixelCoverage exact(Segment s, PixelRecording nearest) {
        long dx = (long) s.x1() - s.x0();
        long dy = (long) s.y1() - s.y0();
        boolean steep = Math.abs(dy) > Math.abs(dx);
        long along = steep ? dy : dx;
        long across = steep ? dx : dy;
        long n = Math.abs(along);
        var shades = new ArrayList<Shade>();
        for (int i = 0; i < nearest.size(); i++) {
            int x = nearest.x(i);
            int y = nearest.y(i);
            long made = Math.abs(steep ? (long) y - s.y0() : (long) x - s.x0());
            long drifted = steep ? (long) x - s.x0() : (long) y - s.y0();
            long offset = across * made - n * drifted;
            int side = Long.signum(offset);
            int beside = n == 0 ? 0 : level(Math.abs(offset), n);
            shades.add(new Shade(i + 1, x, y, CoverageLine.FULL - beside));
            int besideX = steep ? x + side : x;
            int besideY = steep ? y : y + side;
            if (beside > 0 && s.window().contains(besideX, besideY))
                shades.add(new Shade(i + 1, besideX, besideY, beside));
        }
        return new PixelCoverage(shades);
    }

    /** ⌈255·offset/n − ½⌉, at most 127. */
    private static int level(long offset, long n) {
        long rounded = Math.floorDiv(2 * CoverageLine.FULL * offset + n - 1, 2 * n);
        return (int) Math.min(CoverageLine.FULL / 2, rounded);
    }

    /** The pixels of one step: the nearest first. */
    List<Shade> at(int step) {
        return shades.stream().filter(shade -> shade.step == step).toList();
    }

    PixelRecording pixels() {
        var pixels = new PixelRecording(Math.max(1, shades.size()));
        for (Shade shade : shades) pixels.plot(shade.x, shade.y);
        return pixels;
    }

    /** The step that covered each of {@link #pixels}. */
    int[] steps() {
        return shades.stream().mapToInt(Shade::step).toArray();
    }

    /** Missing is what is covered too little, by more than one level, extra what is too much. */
    PixelDifference differenceFrom(PixelCoverage exact) {
        Map<RasterPoint, Integer> wanted = exact.levels();
        Map<RasterPoint, Integer> drawn = levels();
        PixelSet own = PixelSet.of(pixels());
        return new PixelDifference(
                own.filter((x, y) -> Math.abs(excess(drawn, wanted, x, y)) <= TOLERATED),
                PixelSet.of(exact.pixels())
                        .filter((x, y) -> excess(drawn, wanted, x, y) < -TOLERATED),
                own.filter((x, y) -> excess(drawn, wanted, x, y) > TOLERATED));
    }

    /** The largest difference of a pixel's level. */
    int worst(PixelCoverage exact) {
        Map<RasterPoint, Integer> wanted = exact.levels();
        Map<RasterPoint, Integer> drawn = levels();
        int worst = 0;
        for (PixelCoverage each : List.of(this, exact))
            for (Shade s : each.shades)
                worst = Math.max(worst, Math.abs(excess(drawn, wanted, s.x, s.y)));
        return worst;
    }

    private static int excess(
            Map<RasterPoint, Integer> drawn, Map<RasterPoint, Integer> wanted, int x, int y) {
        var pixel = new RasterPoint(x, y);
        return drawn.getOrDefault(pixel, 0) - wanted.getOrDefault(pixel, 0);
    }

    private Map<RasterPoint, Integer> levels() {
        var levels = new HashMap<RasterPoint, Integer>();
        for (Shade s : shades) levels.merge(new RasterPoint(s.x, s.y), s.level, Integer::sum);
        return levels;
    }
}
