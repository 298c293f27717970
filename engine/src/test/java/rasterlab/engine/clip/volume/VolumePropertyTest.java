package rasterlab.engine.clip.volume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Optional;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Checks properties of both methods on every zmin and every segment. */
class VolumePropertyTest {
    private static final int TRIES = 1_000;

    @Provide
    Arbitrary<Double> nearest() {
        return Arbitraries.of(0.5, 0.25, 0.1, 1e-3, 1e-9, 0.999);
    }

    @Provide
    Arbitrary<double[]> segments() {
        return Arbitraries.oneOf(
                        Arbitraries.integers().between(-8, 8).map(i -> i / 4.0),
                        Arbitraries.doubles().between(-2, 2).ofScale(12),
                        Arbitraries.doubles().between(-1e30, 1e30))
                .array(Double[].class)
                .ofSize(6)
                .map(ends -> Arrays.stream(ends).mapToDouble(Double::doubleValue).toArray());
    }

    @Property(tries = TRIES)
    void whatIsLeftIsRightAndInside(
            @ForAll("nearest") double zmin, @ForAll("segments") double[] segment) {
        VolumeCases.assertRight(zmin, segment);
    }

    @Property(tries = TRIES)
    void clippingAgainChangesNothing(
            @ForAll("nearest") double zmin, @ForAll("segments") double[] segment) {
        for (var method : VolumeCases.rightMethods()) {
            var once = VolumeCases.clip(method.implementation(), zmin, segment);
            if (once.isEmpty()) continue;
            var twice = VolumeCases.clip(method.implementation(), zmin, once.get());
            assertArrayEquals(once.get(), twice.orElseThrow(), method.name());
        }
    }

    @Property(tries = TRIES)
    void swappedEndsAndAxesLeaveTheSame(
            @ForAll("nearest") double zmin, @ForAll("segments") double[] s) {
        for (var method : VolumeCases.rightMethods()) {
            var plain = VolumeCases.clip(method.implementation(), zmin, s);
            var back =
                    VolumeCases.clip(
                            method.implementation(), zmin, s[3], s[4], s[5], s[0], s[1], s[2]);
            assertSame(plain, back.map(b -> picked(b, 3, 4, 5, 0, 1, 2)));
            var transposed =
                    VolumeCases.clip(
                            method.implementation(), zmin, s[1], s[0], s[2], s[4], s[3], s[5]);
            assertSame(plain, transposed.map(t -> picked(t, 1, 0, 2, 4, 3, 5)));
        }
    }

    private static double[] picked(double[] from, int... places) {
        return Arrays.stream(places).mapToDouble(place -> from[place]).toArray();
    }

    private static void assertSame(Optional<double[]> one, Optional<double[]> other) {
        assertEquals(one.isPresent(), other.isPresent());
        if (one.isPresent()) assertArrayEquals(one.get(), other.get(), 2 * VolumeClipTopic.RIGHT);
    }
}
