package rasterlab.exercises.line;

import rasterlab.engine.line.ExactLine;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.pixels.PixelPath;

/**
 * The exact pixels of a segment, or on a tie the other candidate where an answer lit it instead.
 */
final class LinePath implements PixelPath {
    private final Segment segment;
    private final long n;
    private final long across;
    private final boolean steep;
    private PixelRecording known = new PixelRecording(1);
    private int knownLimit;

    LinePath(Segment segment) {
        this.segment = segment;
        long dx = Math.abs((long) segment.x1() - segment.x0());
        long dy = Math.abs((long) segment.y1() - segment.y0());
        this.steep = dy > dx;
        this.n = Math.max(dx, dy);
        this.across = Math.min(dx, dy);
    }

    @Override
    public Pixel first() {
        return new Pixel(segment.x0(), segment.y0());
    }

    @Override
    public Pixel last() {
        return new Pixel(segment.x1(), segment.y1());
    }

    @Override
    public PixelPath between(Pixel from, Pixel to) {
        return new LinePath(new Segment(from.x(), from.y(), to.x(), to.y()));
    }

    @Override
    public PixelRecording exact(int limit) {
        if (limit != knownLimit) {
            known = new ExactLine(segment).record(limit);
            knownLimit = limit;
        }
        return known;
    }

    @Override
    public PixelRecording nearest(PixelRecording actual, int limit) {
        PixelRecording exact = exact(limit);
        if (!hasTies(exact.size())) return exact;
        PixelSet drawn = PixelSet.of(actual);
        PixelRecording wanted = new PixelRecording(limit);
        for (int k = 0; k < exact.size(); k++) {
            int x = exact.x(k);
            int y = exact.y(k);
            boolean other =
                    isTie(k)
                            && !drawn.contains(x, y)
                            && drawn.contains(steep ? x + 1 : x, steep ? y : y + 1);
            wanted.plot(other && steep ? x + 1 : x, other && !steep ? y + 1 : y);
        }
        return wanted;
    }

    private boolean hasTies(int steps) {
        for (int k = 0; k < steps; k++) if (isTie(k)) return true;
        return false;
    }

    /**
     * Whether the exact line passes midway between two pixels at step k: k·across/n is a whole
     * number and a half. k &lt; 2¹⁶ and across ≤ 2³², so a long does not overflow.
     */
    private boolean isTie(int k) {
        return n > 0 && 2 * (k * across % n) == n;
    }
}
