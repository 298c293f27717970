package rasterlab.engine.clip.volume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.exact.ExactClip;
import rasterlab.engine.study.Method;

/** Segments in space for tests, and what every method must make of each. */
final class VolumeCases {
    static final VolumeClipTopic TOPIC = new VolumeClipTopic();

    private VolumeCases() {}

    static List<Method<VolumeClipper>> rightMethods() {
        return TOPIC.methods().stream().filter(method -> !method.faulty()).toList();
    }

    static Optional<double[]> clip(VolumeClipper method, double zmin, double... ends) {
        var capture = new PartCapture(10);
        VolumeClipTopic.clip(method, zmin, ends, capture);
        capture.next();
        assertEquals(0, capture.captured().again(), "sent twice");
        return capture.captured().parts().get(0);
    }

    /** Fails unless every method leaves what the exact answer says. */
    static void assertRight(double zmin, double... ends) {
        Optional<double[]> exact = ExactClip.volume(zmin, ends);
        for (var method : rightMethods()) {
            Optional<double[]> actual = clip(method.implementation(), zmin, ends);
            String where = method.name() + " of " + Arrays.toString(ends) + ", zmin " + zmin;
            if (exact.isPresent() != actual.isPresent())
                fail(where + " is misjudged; right is " + exact.map(Arrays::toString));
            actual.ifPresent(part -> assertEnds(zmin, ends, exact.get(), part, where));
        }
    }

    private static void assertEnds(
            double zmin, double[] given, double[] exact, double[] actual, String where) {
        for (int i = 0; i < 6; i++)
            if (!(Math.abs(actual[i] - exact[i]) <= VolumeClipTopic.RIGHT))
                fail(where + " is " + Arrays.toString(actual) + ", not " + Arrays.toString(exact));
        for (int end = 0; end < 6; end += 3) {
            if (!inside(zmin, actual[end], actual[end + 1], actual[end + 2]))
                fail(where + " sticks out at " + Arrays.toString(actual));
            if (inside(zmin, given[end], given[end + 1], given[end + 2]))
                assertArrayEquals(
                        Arrays.copyOfRange(given, end, end + 3),
                        Arrays.copyOfRange(actual, end, end + 3),
                        where + " moves an end that is inside");
        }
    }

    static boolean inside(double zmin, double x, double y, double z) {
        return zmin <= z && z <= 1 && Math.abs(x) <= z && Math.abs(y) <= z;
    }

    static double randomZmin(Random random) {
        return random.nextInt(10) == 0
                ? random.nextDouble()
                : Math.pow(10, -4 * random.nextDouble());
    }

    static double[] randomSegment(Random random) {
        double far = random.nextInt(4) == 0 ? Math.pow(10, 12 * random.nextDouble() - 2) : 1;
        return random.doubles(6).map(r -> far * (4 * r - 2)).toArray();
    }

    /** A segment that passes an edge of the pyramid within a few steps between doubles. */
    static double[] adversary(Random random, double zmin) {
        double z = random.nextInt(3) == 0 ? zmin : random.nextInt(3) == 0 ? 1 : random.nextDouble();
        double x = random.nextBoolean() ? z : -z;
        double y = random.nextBoolean() ? z : z * (2 * random.nextDouble() - 1);
        double[] way = random.doubles(3).map(r -> 2 * r - 1).toArray();
        double on = random.nextInt(3) == 0 ? 0 : random.nextDouble();
        double[] s = {
            x - way[0], y - way[1], z - way[2], x + on * way[0], y + on * way[1], z + on * way[2]
        };
        for (int i = 0; i < 6; i++)
            for (int step = random.nextInt(3); step > 0; step--) s[i] = Math.nextUp(s[i]);
        return s;
    }
}
