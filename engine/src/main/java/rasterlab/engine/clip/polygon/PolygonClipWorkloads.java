package rasterlab.engine.clip.polygon;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import rasterlab.engine.study.Workload;

/**
 * Stars around a window, of a given number of corners each, the same in every run: simple, since
 * their corners have growing angles about one point, and not convex.
 */
final class PolygonClipWorkloads {
    private static final long SEED = 1977;
    private static final int CORNERS_PER_WORKLOAD = 512;
    private static final double SIZE = 100;

    private PolygonClipWorkloads() {}

    static List<Workload<PolygonInWindow>> all() {
        return IntStream.of(4, 16, 64, 256).mapToObj(PolygonClipWorkloads::corners).toList();
    }

    private static Workload<PolygonInWindow> corners(int corners) {
        var random = new Random(SEED + corners);
        var inputs = new ArrayList<PolygonInWindow>();
        for (int i = 0; i < CORNERS_PER_WORKLOAD / corners; i++)
            inputs.add(
                    new PolygonInWindow(
                            PolygonInWindow.rectangle(0, 0, SIZE, SIZE), star(corners, random)));
        return new Workload<>("corners-" + corners, corners, inputs);
    }

    /** A star about a point of the window, its corners near and far in turn. */
    static double[] star(int corners, Random random) {
        double x = SIZE * (0.25 + random.nextDouble() / 2);
        double y = SIZE * (0.25 + random.nextDouble() / 2);
        var xy = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / corners;
            double reach = SIZE * (i % 2 == 0 ? 0.6 : 0.3) * (0.5 + random.nextDouble());
            xy[2 * i] = x + reach * StrictMath.cos(angle);
            xy[2 * i + 1] = y + reach * StrictMath.sin(angle);
        }
        return xy;
    }
}
