package rasterlab.engine.line;

import java.math.BigInteger;
import rasterlab.engine.raster.PixelWindow;

/**
 * The pixels of a line that lie in a window, found without walking there.
 *
 * <p>With n and b the extents along the longer and the shorter axis and t = 1 where the shorter
 * axis's coordinate does not fall, else 0, pixel k of 0..n lies j(k) = ⌊(2·k·b + n − t) / (2·n)⌋
 * pixels across: the nearest to k·b/n, a half to the smaller coordinate. j never falls, so a window
 * holds one run of k: those within it along, and of these the ones from ⌈(2·n·j₀ − n + t) / (2·b)⌉
 * on, where j reaches the window's first row across j₀, and before the like of the row behind its
 * last. Clipping the end points instead would turn the line and light other pixels.
 *
 * @param steep whether y is the longer axis
 * @param signX 1 where x grows or stays, −1 where it falls; the like for {@code signY}
 * @param n extent along the longer axis, 0 to 2³² − 1 steps
 * @param b extent along the shorter axis, at most n
 * @param first k of the first pixel in the window
 * @param count number of pixels in the window; 0 where the line misses it
 * @param across j(first)
 * @param remainder 2·first·b + n − t − 2·n·across: what j(first) leaves over, from 0 to 2·n − 1,
 *     and −1 for a single point
 * @param tie t, 1 where a tie goes to the pixel nearer to the start, else 0
 */
record LineSection(
        boolean steep,
        int signX,
        int signY,
        long n,
        long b,
        long first,
        long count,
        long across,
        long remainder,
        int tie) {

    /** The whole line. */
    static LineSection whole(int x0, int y0, int x1, int y1) {
        var line = new Line(x0, y0, x1, y1);
        return line.from(0, line.n + 1);
    }

    /** The pixels in the window. */
    static LineSection within(PixelWindow window, int x0, int y0, int x1, int y1) {
        var line = new Line(x0, y0, x1, y1);
        if (window.contains(x0, y0) && window.contains(x1, y1)) return line.from(0, line.n + 1);
        long firstX = before(x0, line.signX, window.xmin(), window.xmax());
        long lastX = after(x0, line.signX, window.xmin(), window.xmax());
        long firstY = before(y0, line.signY, window.ymin(), window.ymax());
        long lastY = after(y0, line.signY, window.ymin(), window.ymax());
        return line.steep
                ? line.within(firstY, lastY, firstX, lastX)
                : line.within(firstX, lastX, firstY, lastY);
    }

    /** Steps from {@code start} to the side of the window where the line comes in. */
    private static long before(int start, int sign, int min, int max) {
        return sign > 0 ? (long) min - start : (long) start - max;
    }

    /** Steps from {@code start} to the side of the window where the line goes out. */
    private static long after(int start, int sign, int min, int max) {
        return sign > 0 ? (long) max - start : (long) start - min;
    }

    /** No pixel at all. */
    static LineSection none() {
        return new Line(0, 0, 0, 0).from(0, 0);
    }

    int x(int x0) {
        return (int) (x0 + signX * (steep ? across : first));
    }

    int y(int y0) {
        return (int) (y0 + signY * (steep ? first : across));
    }

    private static final class Line {
        final int signX;
        final int signY;
        final boolean steep;
        final long n;
        final long b;
        final int tie;

        Line(int x0, int y0, int x1, int y1) {
            long dx = Math.abs((long) x1 - x0);
            long dy = Math.abs((long) y1 - y0);
            signX = x1 < x0 ? -1 : 1;
            signY = y1 < y0 ? -1 : 1;
            steep = dy > dx;
            n = steep ? dy : dx;
            b = steep ? dx : dy;
            tie = (steep ? signX : signY) > 0 ? 1 : 0;
        }

        LineSection within(long firstAlong, long lastAlong, long firstAcross, long lastAcross) {
            long from = Math.max(0, firstAlong);
            long to = Math.min(n, lastAlong);
            if (from > to || firstAcross > b || lastAcross < 0) return from(0, 0);
            if (firstAcross > 0) from = Math.max(from, reaching(firstAcross));
            if (lastAcross < b) to = Math.min(to, reaching(lastAcross + 1) - 1);
            return from > to ? from(0, 0) : from(from, to - from + 1);
        }

        /** The smallest k with j(k) ≥ {@code j}, for 0 &lt; j ≤ b. */
        private long reaching(long j) {
            return -floorOfQuotient(-2 * n, j, n - tie, 2 * b);
        }

        LineSection from(long first, long count) {
            long across = first == 0 ? 0 : floorOfQuotient(2 * b, first, n - tie, 2 * n);
            // The products may overflow, their difference does not.
            long remainder = 2 * b * first + n - tie - 2 * n * across;
            return new LineSection(steep, signX, signY, n, b, first, count, across, remainder, tie);
        }
    }

    /** ⌊(a·b + c) / d⌋ for d &gt; 0 and |c| &lt; 2³⁴, also where the product is beyond a long. */
    private static long floorOfQuotient(long a, long b, long c, long d) {
        long product = a * b;
        if (Math.multiplyHigh(a, b) == product >> 63 && Math.abs(product) < 1L << 62)
            return Math.floorDiv(product + c, d);
        BigInteger[] parts =
                BigInteger.valueOf(a)
                        .multiply(BigInteger.valueOf(b))
                        .add(BigInteger.valueOf(c))
                        .divideAndRemainder(BigInteger.valueOf(d));
        long quotient = parts[0].longValueExact();
        return parts[1].signum() < 0 ? quotient - 1 : quotient;
    }
}
