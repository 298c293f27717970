package rasterlab.engine.color;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Workload;

/** Random colours of the 2²⁴ that a screen has. */
final class ColorWorkloads {
    private static final long SEED = 1978;

    private ColorWorkloads() {}

    static List<Workload<Colors>> all() {
        var workloads = new ArrayList<Workload<Colors>>();
        for (int count : new int[] {1, 16, 256}) workloads.add(colors(count));
        return workloads;
    }

    private static Workload<Colors> colors(int count) {
        var random = new Random(SEED + count);
        var components = new double[3 * count];
        for (int i = 0; i < components.length; i++)
            components[i] = Levels.share(random.nextInt(256));
        return new Workload<>(
                "colours-" + count, count, List.of(new Colors(ColorModel.RGB, components)));
    }
}
