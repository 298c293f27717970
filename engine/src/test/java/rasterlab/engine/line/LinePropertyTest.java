package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Raster;

/** Checks properties of every right line on segments that shrink to the smallest counterexample. */
class LinePropertyTest {
    private static final List<String> RIGHT =
            List.of("naive", "dda", "bresenham", "midpoint", "wu");
    private static final LineTopic TOPIC = new LineTopic();
    private static final int SIDE = 64;

    @Provide
    Arbitrary<String> right() {
        return Arbitraries.of(RIGHT);
    }

    @Provide
    Arbitrary<Segment> segments() {
        Arbitrary<Integer> near = Arbitraries.integers().between(-400, 400);
        return near.tuple4().map(t -> new Segment(t.get1(), t.get2(), t.get3(), t.get4()));
    }

    @Provide
    Arbitrary<Segment> anySegments() {
        Arbitrary<Integer> any = Arbitraries.integers();
        Arbitrary<Integer> mixed = Arbitraries.oneOf(any, Arbitraries.integers().between(-9, 73));
        return mixed.tuple4().map(t -> new Segment(t.get1(), t.get2(), t.get3(), t.get4()));
    }

    @Property
    void bothEndsAreLitAndEachStepTouchesTheNext(
            @ForAll("right") String method, @ForAll("segments") Segment s) {
        PixelRecording drawn = draw(method, s);
        int last = drawn.size() - 1;
        assertEquals(s.steps(), last);
        assertEquals(new Segment(s.x0(), s.y0(), s.x1(), s.y1()), ends(drawn));
        for (int i = 0; i < last; i++) {
            int dx = Math.abs(drawn.x(i + 1) - drawn.x(i));
            int dy = Math.abs(drawn.y(i + 1) - drawn.y(i));
            assertEquals(1, Math.max(dx, dy), "step " + i);
        }
    }

    @Property
    void theOtherDirectionLightsTheSamePixels(
            @ForAll("right") String method, @ForAll("segments") Segment s) {
        PixelSet there = PixelSet.of(draw(method, s));
        PixelRecording back = draw(method, s.reversed());
        for (int i = 0; i < back.size(); i++)
            assertTrue(there.contains(back.x(i), back.y(i)), "(" + back.x(i) + ", " + back.y(i));
    }

    /** Swapping the axes mirrors the line: the tie rule favours no axis. */
    @Property
    void swappedAxesGiveTheMirroredLine(
            @ForAll("right") String method, @ForAll("segments") Segment s) {
        PixelRecording drawn = draw(method, s);
        PixelRecording mirrored = draw(method, new Segment(s.y0(), s.x0(), s.y1(), s.x1()));
        if (Math.abs(s.x1() - s.x0()) == Math.abs(s.y1() - s.y0())) return;
        for (int i = 0; i < drawn.size(); i++) {
            assertEquals(drawn.x(i), mirrored.y(i), "pixel " + i);
            assertEquals(drawn.y(i), mirrored.x(i), "pixel " + i);
        }
    }

    @Property
    void aMovedLineIsTheSameLineMoved(
            @ForAll("right") String method,
            @ForAll("segments") Segment s,
            @ForAll @IntRange(min = -2_000_000_000, max = 2_000_000_000) int byX,
            @ForAll @IntRange(min = -2_000_000_000, max = 2_000_000_000) int byY) {
        PixelRecording drawn = draw(method, s);
        var moved = new Segment(s.x0() + byX, s.y0() + byY, s.x1() + byX, s.y1() + byY);
        PixelRecording there = draw(method, moved);
        for (int i = 0; i < drawn.size(); i++) {
            assertEquals(drawn.x(i) + byX, there.x(i), "pixel " + i);
            assertEquals(drawn.y(i) + byY, there.y(i), "pixel " + i);
        }
    }

    @Property
    void aWindowShowsThePixelsOfTheWholeLine(@ForAll("segments") Segment s) {
        var window = new PixelWindow(-31, -7, 58, 40);
        List<List<Double>> expected = inside(window, new BresenhamLine(), s);
        for (WindowedLine line : List.of(new BresenhamLine(), new MidpointLine())) {
            var walk = line.walk(s.x0(), s.y0(), s.x1(), s.y1(), window);
            var seen = new ArrayList<List<Double>>();
            while (walk.advance()) seen.add(step(walk));
            if (line instanceof BresenhamLine) assertEquals(expected, seen);
            else assertEquals(inside(window, line, s), seen);
        }
    }

    /**
     * Lines of up to 2³² pixels, which nobody walks whole: each shown pixel against the exact one.
     */
    @Property
    void aWindowShowsExactlyItsPixelsOfAnyLine(@ForAll("anySegments") Segment s) {
        var window = new PixelWindow(0, 0, SIDE - 1, SIDE - 1);
        var exact = new ExactLine(s);
        var walk = new BresenhamLine().walk(s.x0(), s.y0(), s.x1(), s.y1(), window);
        long last = -2;
        while (walk.advance()) {
            long k = longerStep(s, walk.x(), walk.y());
            assertEquals(exact.x(k), walk.x(), "pixel " + k);
            assertEquals(exact.y(k), walk.y(), "pixel " + k);
            assertTrue(window.contains(walk.x(), walk.y()), "pixel " + k);
            if (last == -2) assertOutside(window, exact, k - 1);
            else assertEquals(last + 1, k);
            last = k;
        }
        if (last >= 0) assertOutside(window, exact, last + 1);
    }

    @Property
    void thePictureGetsBresenhamsPixels(@ForAll("anySegments") Segment s) {
        var picture = new Raster(SIDE, SIDE);
        RasterLine.draw(s.x0(), s.y0(), s.x1(), s.y1(), -1, picture);
        var lit = new HashSet<List<Integer>>();
        for (int y = 0; y < SIDE; y++)
            for (int x = 0; x < SIDE; x++) if (picture.argb(x, y) != 0) lit.add(List.of(x, y));
        var expected = new HashSet<List<Integer>>();
        var window = PixelWindow.of(picture);
        var walk = new BresenhamLine().walk(s.x0(), s.y0(), s.x1(), s.y1(), window);
        while (walk.advance()) expected.add(List.of(walk.x(), walk.y()));
        assertEquals(expected, lit);
    }

    @Property
    void theCoveragesOfAStepAddUpAndAreRightToALevel(@ForAll("segments") Segment s) {
        var levels = new HashMap<Integer, Integer>();
        boolean steep = Math.abs(s.y1() - s.y0()) > Math.abs(s.x1() - s.x0());
        new WuLine()
                .shade(
                        s.x0(),
                        s.y0(),
                        s.x1(),
                        s.y1(),
                        (x, y, c) -> {
                            levels.merge(steep ? y : x, c, Integer::sum);
                            assertEquals(255 * coverage(s, x, y), c, 0.501, x + ", " + y);
                        });
        assertEquals(s.steps() + 1, levels.size());
        levels.forEach((along, sum) -> assertEquals(255, sum, "at " + along));
    }

    /** Both pixels are half covered on a tie, and rounding errors must not prefer the neighbour. */
    @Test
    void theNearestPixelHasAtLeastHalfTheLight() {
        for (int n = 0; n <= 64; n++)
            for (int b = -n; b <= n; b++) {
                var nearest = new HashSet<List<Integer>>();
                new BresenhamLine().draw(0, 0, n, b, (x, y) -> nearest.add(List.of(x, y)));
                String line = "(0, 0)→(" + n + ", " + b + ")";
                new WuLine()
                        .shade(
                                0,
                                0,
                                n,
                                b,
                                (x, y, c) ->
                                        assertEquals(
                                                nearest.contains(List.of(x, y)),
                                                c >= 128,
                                                line + " at " + x + ", " + y + ": " + c));
            }
    }

    /** 1 − the distance across from the exact line, where the line passes by at all. */
    private static double coverage(Segment s, int x, int y) {
        boolean steep = Math.abs((double) s.y1() - s.y0()) > Math.abs((double) s.x1() - s.x0());
        double distance =
                steep
                        ? Math.abs(x - exactAcross(y, s.y0(), s.y1(), s.x0(), s.x1()))
                        : Math.abs(y - exactAcross(x, s.x0(), s.x1(), s.y0(), s.y1()));
        return Math.max(0, 1 - distance);
    }

    /** The exact distance across, infinite where the line does not come to that place along. */
    private static double exactAcross(
            double at, double from, double to, double acrossFrom, double acrossTo) {
        if (at < Math.min(from, to) || at > Math.max(from, to)) return Double.POSITIVE_INFINITY;
        if (from == to) return acrossFrom;
        return acrossFrom + (at - from) * (acrossTo - acrossFrom) / (to - from);
    }

    /**
     * The widest picture and nearly the longest lines of the fixed-point walk, where its places are
     * needed.
     */
    @Test
    void theWidestPictureGetsBresenhamsPixelsOfLongLines() {
        var random = new Random(1965);
        var picture = new Raster(Raster.LARGEST_SIDE, 192);
        for (int i = 0; i < 500; i++) {
            int n = (1 << 22) - random.nextInt(64);
            int b = random.nextInt(n / 64);
            int before = random.nextInt(n - Raster.LARGEST_SIDE);
            int y0 = (int) (20 - (long) before * b / n);
            boolean back = random.nextBoolean();
            var s = new Segment(-before, y0, n - before, y0 + b);
            if (back) s = s.reversed();
            picture.clear(0);
            RasterLine.draw(s.x0(), s.y0(), s.x1(), s.y1(), -1, picture);
            var walk =
                    new BresenhamLine()
                            .walk(s.x0(), s.y0(), s.x1(), s.y1(), PixelWindow.of(picture));
            while (walk.advance())
                assertEquals(-1, picture.argb(walk.x(), walk.y()), s + " at " + walk.x());
        }
    }

    /** The last cell has the index 2²⁶ − 1, which with 38 places behind the point fills a long. */
    @Test
    void theLargestPictureGetsBresenhamsPixelsInItsLastCells() {
        int last = Raster.LARGEST_SIDE - 1;
        var picture = new Raster(last + 1, last + 1);
        for (Segment s :
                List.of(
                        new Segment(last, last, last - 190, 0),
                        new Segment(last - 333, 0, last, last),
                        new Segment(last, last, 0, last - 777),
                        new Segment(last + 50, last + 9_999, 12, -5))) {
            RasterLine.draw(s.x0(), s.y0(), s.x1(), s.y1(), -1, picture);
            var walk =
                    new BresenhamLine()
                            .walk(s.x0(), s.y0(), s.x1(), s.y1(), PixelWindow.of(picture));
            while (walk.advance())
                assertEquals(-1, picture.argb(walk.x(), walk.y()), s + " at " + walk.y());
        }
    }

    private static long longerStep(Segment s, int x, int y) {
        long dx = Math.abs((long) s.x1() - s.x0());
        long dy = Math.abs((long) s.y1() - s.y0());
        return dy > dx ? Math.abs((long) y - s.y0()) : Math.abs((long) x - s.x0());
    }

    private static void assertOutside(PixelWindow window, ExactLine exact, long k) {
        if (k < 0 || k >= exact.size()) return;
        assertTrue(!window.contains(exact.x(k), exact.y(k)), "pixel " + k + " is left out");
    }

    private static List<List<Double>> inside(PixelWindow window, SteppedLine line, Segment s) {
        var walk = line.walk(s.x0(), s.y0(), s.x1(), s.y1());
        var seen = new ArrayList<List<Double>>();
        while (walk.advance()) if (window.contains(walk.x(), walk.y())) seen.add(step(walk));
        return seen;
    }

    private static List<Double> step(LineWalk walk) {
        return List.of((double) walk.x(), (double) walk.y(), walk.decision());
    }

    private static PixelRecording draw(String method, Segment s) {
        return TOPIC.record(TOPIC.method(method).implementation(), s, (int) s.steps() + 2);
    }

    private static Segment ends(PixelRecording drawn) {
        int last = drawn.size() - 1;
        return new Segment(drawn.x(0), drawn.y(0), drawn.x(last), drawn.y(last));
    }
}
