package rasterlab.engine.circle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelRecording;

@Tag("slow")
class ArcPropertyTest {
    private static final List<CircleRasterizer> CIRCLES =
            List.of(new BresenhamCircle(), new MidpointCircle());
    private static final List<EllipseRasterizer> ELLIPSES =
            List.of(new BresenhamEllipse(), new MidpointEllipse());

    private record Pixel(int x, int y) {}

    /** A set of pixels that takes none twice. */
    private static final class Once implements Pixels {
        final Set<Pixel> pixels = new HashSet<>();

        @Override
        public void plot(int x, int y) {
            assertTrue(pixels.add(new Pixel(x, y)), "(" + x + ", " + y + ") is drawn again");
        }
    }

    private static Set<Pixel> exact(int a, int b) {
        var once = new Once();
        new ExactEllipse(a, b).draw(0, 0, once);
        return once.pixels;
    }

    private static Set<Pixel> drawn(EllipseRasterizer method, int a, int b) {
        var once = new Once();
        method.draw(0, 0, a, b, once);
        return once.pixels;
    }

    @Test
    void everySmallCircleIsExact() {
        for (int r = 0; r <= 400; r++)
            for (CircleRasterizer method : CIRCLES) {
                var once = new Once();
                method.draw(0, 0, r, once);
                assertEquals(exact(r, r), once.pixels, method.getClass() + ", radius " + r);
            }
    }

    @Test
    void everySmallEllipseIsExact() {
        for (int a = 0; a <= 70; a++)
            for (int b = 0; b <= 70; b++)
                for (EllipseRasterizer method : ELLIPSES)
                    assertEquals(
                            exact(a, b),
                            drawn(method, a, b),
                            method.getClass() + ", half-axes " + a + ", " + b);
    }

    @Property(tries = 300)
    void anyEllipseIsExact(
            @ForAll @IntRange(max = 3000) int a, @ForAll @IntRange(max = 3000) int b) {
        for (EllipseRasterizer method : ELLIPSES) assertEquals(exact(a, b), drawn(method, a, b));
    }

    @Property(tries = 300)
    void eachPixelTouchesTheNext(
            @ForAll @IntRange(max = 3000) int a, @ForAll @IntRange(max = 3000) int b) {
        var walk = new BresenhamEllipse().walk(a, b);
        assertTrue(walk.advance());
        assertEquals(new Pixel(0, b), new Pixel(walk.u(), walk.v()));
        int u = 0;
        int v = b;
        while (walk.advance()) {
            assertEquals(1, Math.max(walk.u() - u, v - walk.v()), u + ", " + v);
            u = walk.u();
            v = walk.v();
        }
        assertEquals(new Pixel(a, 0), new Pixel(u, v));
    }

    @Property(tries = 300)
    void anEllipseLyingDownIsTheStandingOneMirrored(
            @ForAll @IntRange(max = 1500) int a, @ForAll @IntRange(max = 1500) int b) {
        for (EllipseRasterizer method : ELLIPSES) {
            var mirrored = new HashSet<Pixel>();
            for (Pixel p : drawn(method, b, a)) mirrored.add(new Pixel(p.y, p.x));
            assertEquals(drawn(method, a, b), mirrored);
        }
    }

    @Property(tries = 300)
    void aMovedCircleIsTheSameCircleMoved(
            @ForAll @IntRange(max = 300) int r, @ForAll short byX, @ForAll short byY) {
        for (CircleRasterizer method : CIRCLES) {
            var here = new PixelRecording(10_000);
            var there = new PixelRecording(10_000);
            method.draw(0, 0, r, here);
            method.draw(byX, byY, r, there);
            for (int i = 0; i < here.size(); i++) {
                assertEquals(here.x(i) + byX, there.x(i));
                assertEquals(here.y(i) + byY, there.y(i));
            }
        }
    }

    /** A whole octant each; with {@code -Drasterlab.full=true} those of the largest radii. */
    @ParameterizedTest
    @MethodSource("largeRadii")
    void everyColumnOfALargeCirclesOctantHasItsNearestPixel(int r) {
        assertOctant(new MidpointCircle().walk(r), r);
        assertOctant(new BresenhamCircle().walk(r), r);
    }

    static IntStream largeRadii() {
        return Boolean.getBoolean("rasterlab.full")
                ? IntStream.of((1 << 26) - 1, 1 << 26, 1_234_567_891, Integer.MAX_VALUE)
                : IntStream.of((1 << 21) - 1, 1 << 21, 1_234_567);
    }

    private static void assertOctant(ArcWalk walk, int r) {
        int u = -1;
        int v = r;
        boolean more = walk.advance();
        while (more && walk.u() <= walk.v()) {
            if (walk.u() != u + 1) assertEquals(u + 1, walk.u(), "column");
            u++;
            v = walk.v();
            // |v − √(r² − u²)| < ½, as v² − v + ¼ < r² − u² < v² + v + ¼ without overflow
            long rest = ((long) r - v) * ((long) r + v) - (long) u * u;
            if (rest <= -v || rest > v) fail("column " + u + ", row " + v + ", radius " + r);
            more = walk.advance();
        }
        assertTrue(v - u <= 1, "ends in column " + u + ", row " + v);
    }

    @Test
    @org.junit.jupiter.api.Tag("slow") // The other Tag is that of the properties.
    void theLargestEllipsesAreExact() {
        int most = MidpointEllipse.LARGEST;
        for (int other : new int[] {0, 1, 2, 1000, most / 2 + 1, most - 1, most})
            for (EllipseRasterizer method : ELLIPSES) {
                assertSameQuadrant(method, most, other);
                assertSameQuadrant(method, other, most);
            }
    }

    private static void assertSameQuadrant(EllipseRasterizer method, int a, int b) {
        var expected = new long[] {0, 0};
        new ExactEllipse(a, b).quadrant((u, v) -> add(expected, u, v));
        var seen = new long[] {0, 0};
        ArcWalk walk = ((SteppedEllipse) method).walk(a, b);
        while (walk.advance()) add(seen, walk.u(), walk.v());
        assertEquals(expected[0], seen[0], method.getClass() + " " + a + ", " + b + ": pixels");
        assertEquals(expected[1], seen[1], method.getClass() + " " + a + ", " + b + ": their hash");
    }

    /** A sum over all pixels that does not depend on their order (SplitMix64's finisher). */
    private static void add(long[] sum, int u, int v) {
        long z = ((long) u << 32 | v) + 0x9E3779B97F4A7C15L;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        sum[0]++;
        sum[1] += z ^ z >>> 31;
    }
}
