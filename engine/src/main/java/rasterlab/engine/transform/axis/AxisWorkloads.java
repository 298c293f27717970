package rasterlab.engine.transform.axis;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;

/** Points about one axis of any direction, as many as asked, the same in every run. */
final class AxisWorkloads {
    private static final long SEED = 1840;
    private static final int POINTS_PER_WORKLOAD = 4_096;

    private AxisWorkloads() {}

    static List<Workload<AxisTurn>> all() {
        return List.of(points(1), points(16), points(256), points(4_096));
    }

    private static Workload<AxisTurn> points(int count) {
        var random = new Random(SEED + count);
        var turns = new ArrayList<AxisTurn>();
        for (int i = 0; i < POINTS_PER_WORKLOAD / Math.max(16, count); i++)
            turns.add(
                    new AxisTurn(
                            random.doubles(3, -100, 100).toArray(),
                            random.doubles(3, -1, 1).toArray(),
                            random.nextDouble(-360, 360),
                            random.doubles(3L * count, -100, 100).toArray()));
        return new Workload<>("points-" + count, count, turns);
    }
}
