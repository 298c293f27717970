package rasterlab.engine.clip.segment;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.exact.ExactClip;
import rasterlab.engine.study.Method;

/** Segments for tests, and what every right method must make of each. */
final class SegmentCases {
    private static final SegmentClipTopic TOPIC = new SegmentClipTopic();

    private SegmentCases() {}

    static List<Method<SegmentClipper>> rightMethods() {
        return TOPIC.methods().stream().filter(method -> !method.faulty()).toList();
    }

    static Optional<double[]> clip(SegmentClipper method, ClipWindow window, double... ends) {
        var capture = new PartCapture(10);
        SegmentClipTopic.clip(method, window, ends, capture);
        capture.next();
        assertEquals(0, capture.captured().again(), "sent twice");
        return capture.captured().parts().get(0);
    }

    /** Fails unless every right method leaves what the exact answer says. */
    static void assertRight(ClipWindow window, double... ends) {
        Optional<double[]> exact = ExactClip.plane(window.sides(), ends);
        for (var method : rightMethods()) {
            Optional<double[]> actual = clip(method.implementation(), window, ends);
            String where = method.name() + " of " + Arrays.toString(ends) + " in " + window;
            if (exact.isPresent() != actual.isPresent())
                fail(where + " is misjudged; right is " + text(exact));
            actual.ifPresent(part -> assertEnds(window, ends, exact.get(), part, where));
        }
    }

    private static String text(Optional<double[]> ends) {
        return ends.map(Arrays::toString).orElse("nothing");
    }

    private static void assertEnds(
            ClipWindow window, double[] given, double[] exact, double[] actual, String where) {
        double most = SegmentClipTopic.RIGHT_UNITS * window.unit();
        for (int i = 0; i < 4; i++)
            if (!(Math.abs(actual[i] - exact[i]) <= most))
                fail(where + " is " + Arrays.toString(actual) + ", not " + Arrays.toString(exact));
        for (int end = 0; end < 4; end += 2) {
            assertTrue(inside(window, actual[end], actual[end + 1]), where + " sticks out");
            if (inside(window, given[end], given[end + 1]))
                assertArrayEquals(
                        new double[] {given[end] + 0.0, given[end + 1] + 0.0},
                        new double[] {actual[end] + 0.0, actual[end + 1] + 0.0},
                        where + " moves an end that is inside");
        }
    }

    static boolean inside(ClipWindow window, double x, double y) {
        return window.xmin() <= x && x <= window.xmax() && window.ymin() <= y && y <= window.ymax();
    }

    /**
     * A window of random place and extent, from a thousandth to a thousand, seldom without area.
     */
    static ClipWindow randomWindow(Random random) {
        double x = 20 * random.nextDouble() - 10;
        double y = 20 * random.nextDouble() - 10;
        double width = random.nextInt(20) == 0 ? 0 : Math.pow(10, 6 * random.nextDouble() - 3);
        double height = random.nextInt(20) == 0 ? 0 : Math.pow(10, 6 * random.nextDouble() - 3);
        return new ClipWindow(x, y, x + width, y + height);
    }

    /** Ends around the window, now near, now far. */
    static double[] randomSegment(Random random, ClipWindow window) {
        double far = random.nextInt(4) == 0 ? Math.pow(10, 20 * random.nextDouble() - 5) : 1;
        double width = Math.max(window.xmax() - window.xmin(), 1e-3);
        double height = Math.max(window.ymax() - window.ymin(), 1e-3);
        return new double[] {
            window.xmin() + width * far * (3 * random.nextDouble() - 1),
            window.ymin() + height * far * (3 * random.nextDouble() - 1),
            window.xmin() + width * far * (3 * random.nextDouble() - 1),
            window.ymin() + height * far * (3 * random.nextDouble() - 1)
        };
    }

    /**
     * A segment that passes a corner within a few steps between doubles, or ends on a side or as
     * near to it.
     */
    static double[] adversary(Random random, ClipWindow window) {
        double x = random.nextBoolean() ? window.xmin() : window.xmax();
        double y = random.nextBoolean() ? window.ymin() : window.ymax();
        double reach = Math.pow(10, 8 * random.nextDouble() - 4);
        double dx = reach * (2 * random.nextDouble() - 1);
        double dy = reach * (2 * random.nextDouble() - 1);
        double on = random.nextInt(3) == 0 ? 0 : random.nextDouble();
        return new double[] {
            nudged(random, x - dx),
            nudged(random, y - dy),
            nudged(random, x + on * dx),
            nudged(random, y + on * dy)
        };
    }

    private static double nudged(Random random, double value) {
        double nudged = value;
        int steps = random.nextInt(7) - 3;
        for (int i = 0; i < Math.abs(steps); i++)
            nudged = steps < 0 ? Math.nextDown(nudged) : Math.nextUp(nudged);
        return nudged;
    }
}
