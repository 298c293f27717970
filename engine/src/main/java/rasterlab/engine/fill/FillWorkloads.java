package rasterlab.engine.fill;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;

/** Square pictures with small holes, filled from the middle; the same in every run. */
final class FillWorkloads {
    private static final long SEED = 1979;
    private static final double HOLES = 0.1;

    private FillWorkloads() {}

    static List<Workload<FillTask>> all() {
        return List.of(side(8), side(32), side(128), side(512));
    }

    private static Workload<FillTask> side(int side) {
        return new Workload<>("side-" + side, side * side, List.of(task(side, 4), task(side, 8)));
    }

    private static FillTask task(int side, int connectivity) {
        var random = new Random(SEED + side);
        var rows = new ArrayList<String>();
        for (int y = 0; y < side; y++) {
            var row = new StringBuilder();
            for (int x = 0; x < side; x++) row.append(random.nextDouble() < HOLES ? '#' : '.');
            if (y == side / 2) row.setCharAt(side / 2, '.');
            rows.add(row.toString());
        }
        return new FillTask(rows, side / 2, side / 2, '*', connectivity);
    }
}
