package rasterlab.engine.clip.segment;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import rasterlab.engine.study.Workload;

/**
 * A hundred segments around a window, of which a given number is visible, the same in every run.
 *
 * <p>A visible segment passes through a random point of the window. Of the invisible ones half lie
 * beyond one side, half pass a corner outside, with no side that both ends are beyond.
 */
final class SegmentClipWorkloads {
    private static final long SEED = 1967;
    private static final int SEGMENTS = 100;
    private static final int INPUTS = 10;
    private static final double SIZE = 100;

    private SegmentClipWorkloads() {}

    static List<Workload<SegmentsInWindow>> all() {
        return IntStream.of(5, 25, 50, 75, 95).mapToObj(SegmentClipWorkloads::visible).toList();
    }

    private static Workload<SegmentsInWindow> visible(int visible) {
        var random = new Random(SEED + visible);
        var inputs = new ArrayList<SegmentsInWindow>();
        for (int i = 0; i < INPUTS; i++) inputs.add(input(visible, random));
        return new Workload<>("visible-" + visible, visible, inputs);
    }

    private static SegmentsInWindow input(int visible, Random random) {
        var segments = new ArrayList<double[]>();
        for (int i = 0; i < SEGMENTS; i++)
            segments.add(
                    i < visible
                            ? through(random)
                            : i % 2 == 0 ? beyondSide(random) : pastCorner(random));
        Collections.shuffle(segments, random);
        return new SegmentsInWindow(new ClipWindow(0, 0, SIZE, SIZE), segments);
    }

    private static double[] through(Random random) {
        double x = random.nextDouble() * SIZE;
        double y = random.nextDouble() * SIZE;
        double angle = random.nextDouble() * 2 * Math.PI;
        double back = random.nextDouble() * SIZE;
        double on = random.nextDouble() * SIZE;
        double dx = StrictMath.cos(angle);
        double dy = StrictMath.sin(angle);
        return new double[] {x - back * dx, y - back * dy, x + on * dx, y + on * dy};
    }

    private static double[] beyondSide(Random random) {
        double x0 = -random.nextDouble() * SIZE;
        double x1 = -random.nextDouble() * SIZE;
        double y0 = (2 * random.nextDouble() - 0.5) * SIZE;
        double y1 = (2 * random.nextDouble() - 0.5) * SIZE;
        return turned(random.nextInt(4), x0, y0, x1, y1);
    }

    /**
     * A segment from left of the window to below it, by (−a, 0) and (0, −b): outside the corner (0,
     * 0).
     */
    private static double[] pastCorner(Random random) {
        double a = (0.01 + random.nextDouble() / 2) * SIZE;
        double b = (0.01 + random.nextDouble() / 2) * SIZE;
        double left = random.nextDouble();
        double below = random.nextDouble();
        return turned(random.nextInt(4), -a * (1 + left), b * left, a * below, -b * (1 + below));
    }

    /** The segment after quarter turns about the window's centre. */
    private static double[] turned(int quarters, double x0, double y0, double x1, double y1) {
        double[] s = {x0, y0, x1, y1};
        for (int i = 0; i < quarters; i++) s = new double[] {SIZE - s[1], s[0], SIZE - s[3], s[2]};
        return s;
    }
}
