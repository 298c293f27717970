package rasterlab.engine.line;

import java.math.BigInteger;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;

/**
 * The right answer for one segment, in unbounded rational arithmetic.
 *
 * <p>Pixel k of 0..n is the point at the share k/n of the way. Each of its coordinates is c0 +
 * k·(c1 − c0)/n, rounded to the nearest whole number, a half to the smaller one: ⌈c − ½⌉. Shares no
 * code with the methods it judges.
 */
public final class ExactLine {
    private final Segment segment;
    private final BigInteger n;

    public ExactLine(Segment segment) {
        this.segment = segment;
        BigInteger width = difference(segment.x0(), segment.x1()).abs();
        BigInteger height = difference(segment.y0(), segment.y1()).abs();
        n = width.max(height);
    }

    /** Number of pixels of the whole segment, n + 1: from 1 to 2³². */
    public long size() {
        return n.longValueExact() + 1;
    }

    /** Column of pixel {@code k}, 0 being the first. */
    public int x(long k) {
        return coordinate(segment.x0(), segment.x1(), k);
    }

    /** Row of pixel {@code k}, 0 being the first. */
    public int y(long k) {
        return coordinate(segment.y0(), segment.y1(), k);
    }

    /** The first {@code limit} pixels of those in the window, or all if there are fewer. */
    public PixelRecording record(int limit) {
        var recording = new PixelRecording(limit);
        for (long k = first(); k < size() && recording.size() < limit; k++) {
            int x = x(k);
            int y = y(k);
            if (isPast(x, y)) break;
            if (segment.window().contains(x, y)) recording.plot(x, y);
        }
        return recording;
    }

    private boolean isWide() {
        return Math.abs((long) segment.x1() - segment.x0()) == segment.steps();
    }

    /** The first pixel that may lie in the window: along the longer axis every step is one. */
    private long first() {
        PixelWindow window = segment.window();
        if (isWide()) return first(segment.x0(), segment.x1(), window.xmin(), window.xmax());
        return first(segment.y0(), segment.y1(), window.ymin(), window.ymax());
    }

    private static long first(long from, long to, long least, long most) {
        return Math.max(0, from <= to ? least - from : from - most);
    }

    /** Whether that pixel of the segment and all that follow lie beyond the window. */
    private boolean isPast(int x, int y) {
        PixelWindow window = segment.window();
        if (isWide()) return segment.x0() <= segment.x1() ? x > window.xmax() : x < window.xmin();
        return segment.y0() <= segment.y1() ? y > window.ymax() : y < window.ymin();
    }

    private int coordinate(int from, int to, long k) {
        if (k < 0 || k >= size())
            throw new IndexOutOfBoundsException("pixel " + k + " of a line of " + size());
        if (n.signum() == 0) return from;
        // ⌈c0 + k·(c1 − c0)/n − ½⌉ = −⌊(n − 2·n·c0 − 2·k·(c1 − c0)) / (2·n)⌋
        BigInteger twiceN = n.shiftLeft(1);
        BigInteger moved = difference(from, to).multiply(BigInteger.valueOf(2 * k));
        BigInteger numerator =
                n.subtract(twiceN.multiply(BigInteger.valueOf(from))).subtract(moved);
        return floor(numerator, twiceN).negate().intValueExact();
    }

    private static BigInteger floor(BigInteger numerator, BigInteger positiveDenominator) {
        BigInteger[] parts = numerator.divideAndRemainder(positiveDenominator);
        return parts[1].signum() < 0 ? parts[0].subtract(BigInteger.ONE) : parts[0];
    }

    private static BigInteger difference(int from, int to) {
        return BigInteger.valueOf(to).subtract(BigInteger.valueOf(from));
    }
}
