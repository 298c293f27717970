package rasterlab.engine.clip.segment;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Checks properties of every right method on every window and segment. */
class SegmentPropertyTest {
    private static final int TRIES = 1_000;

    @Provide
    Arbitrary<ClipWindow> windows() {
        return Combinators.combine(coordinates(), coordinates(), coordinates(), coordinates())
                .as(
                        (a, b, c, d) ->
                                new ClipWindow(
                                        Math.min(a, c),
                                        Math.min(b, d),
                                        Math.max(a, c),
                                        Math.max(b, d)));
    }

    @Provide
    Arbitrary<double[]> segments() {
        return coordinates()
                .array(Double[].class)
                .ofSize(4)
                .map(ends -> Arrays.stream(ends).mapToDouble(Double::doubleValue).toArray());
    }

    /** Coordinates that are often small whole numbers, so that segments meet corners and sides. */
    private static Arbitrary<Double> coordinates() {
        return Arbitraries.oneOf(
                Arbitraries.integers().between(-4, 4).map(Integer::doubleValue),
                Arbitraries.doubles().between(-5, 5).ofScale(12),
                Arbitraries.doubles().between(-1e30, 1e30));
    }

    @Property(tries = TRIES)
    void whatIsLeftLiesInTheWindow(
            @ForAll("windows") ClipWindow window, @ForAll("segments") double[] segment) {
        for (var method : SegmentCases.rightMethods())
            SegmentCases.clip(method.implementation(), window, segment)
                    .ifPresent(
                            part ->
                                    assertTrue(
                                            SegmentCases.inside(window, part[0], part[1])
                                                    && SegmentCases.inside(
                                                            window, part[2], part[3]),
                                            method.name() + Arrays.toString(part)));
    }

    @Property(tries = TRIES)
    void clippingAgainChangesNothing(
            @ForAll("windows") ClipWindow window, @ForAll("segments") double[] segment) {
        for (var method : SegmentCases.rightMethods()) {
            var once = SegmentCases.clip(method.implementation(), window, segment);
            if (once.isEmpty()) continue;
            var twice = SegmentCases.clip(method.implementation(), window, once.get());
            assertArrayEquals(plain(once.get()), plain(twice.orElseThrow()), method.name());
        }
    }

    /** −0 and 0 are one place. */
    private static double[] plain(double[] ends) {
        return Arrays.stream(ends).map(coordinate -> coordinate + 0.0).toArray();
    }

    @Property(tries = TRIES)
    void swappedEndsLeaveTheSameTheOtherWayRound(
            @ForAll("windows") ClipWindow window, @ForAll("segments") double[] s) {
        for (var method : SegmentCases.rightMethods()) {
            var there = SegmentCases.clip(method.implementation(), window, s);
            var back = SegmentCases.clip(method.implementation(), window, s[2], s[3], s[0], s[1]);
            assertSame(window, there, back.map(b -> new double[] {b[2], b[3], b[0], b[1]}), method);
        }
    }

    /** Sides come in another order when they are mirrored and transposed. */
    @Property(tries = TRIES)
    void theOrderOfTheSidesIsIrrelevant(
            @ForAll("windows") ClipWindow w, @ForAll("segments") double[] s) {
        var mirrored = new ClipWindow(-w.xmax(), w.ymin(), -w.xmin(), w.ymax());
        var transposed = new ClipWindow(w.ymin(), w.xmin(), w.ymax(), w.xmax());
        for (var method : SegmentCases.rightMethods()) {
            var implementation = method.implementation();
            var plain = SegmentCases.clip(implementation, w, s);
            assertSame(
                    w,
                    plain,
                    SegmentCases.clip(implementation, mirrored, -s[0], s[1], -s[2], s[3])
                            .map(m -> new double[] {-m[0], m[1], -m[2], m[3]}),
                    method);
            assertSame(
                    w,
                    plain,
                    SegmentCases.clip(implementation, transposed, s[1], s[0], s[3], s[2])
                            .map(t -> new double[] {t[1], t[0], t[3], t[2]}),
                    method);
        }
    }

    private static void assertSame(
            ClipWindow window, Optional<double[]> one, Optional<double[]> other, Object method) {
        assertEquals(one.isPresent(), other.isPresent(), method::toString);
        if (one.isPresent())
            assertArrayEquals(
                    one.get(),
                    other.get(),
                    2 * SegmentClipTopic.RIGHT_UNITS * window.unit() + Double.MIN_VALUE,
                    method::toString);
    }
}
