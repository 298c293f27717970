package rasterlab.engine.transform.rotate;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;

/** The drift study: from one turn to ten million, by angles that are no whole degrees. */
final class RotateWorkloads {
    private static final long SEED = 1986;
    private static final int TURNS_PER_WORKLOAD = 1_000;

    private RotateWorkloads() {}

    static List<Workload<Turns>> all() {
        var workloads = new ArrayList<Workload<Turns>>();
        for (int times = 1; times <= 10_000_000; times *= 10) workloads.add(turns(times));
        return workloads;
    }

    private static Workload<Turns> turns(int times) {
        var random = new Random(SEED + times);
        var inputs = new ArrayList<Turns>();
        for (int i = 0; i < Math.max(1, Math.min(10, TURNS_PER_WORKLOAD / times)); i++)
            inputs.add(
                    new Turns(
                            random.nextDouble(-180, 180),
                            times,
                            random.doubles(2, -100, 100).toArray()));
        return new Workload<>("turns-" + times, times, inputs);
    }
}
