package rasterlab.engine.light.shade;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.study.Workload;

/** Points that see both the light and the eye, with directions of length 1. */
final class ShadeWorkloads {
    private static final long SEED = 1975;

    private ShadeWorkloads() {}

    static List<Workload<LitPoints>> all() {
        var workloads = new ArrayList<Workload<LitPoints>>();
        for (int count : new int[] {1, 16, 256}) {
            var random = new Random(SEED + count);
            var points = new ArrayList<LitPoint>();
            for (int i = 0; i < count; i++) points.add(point(random));
            workloads.add(new Workload<>("points-" + count, count, List.of(new LitPoints(points))));
        }
        return workloads;
    }

    private static LitPoint point(Random random) {
        double[] dim = {0.1, 0.1, 0.1};
        var material =
                new SurfaceMaterial(
                        dim,
                        random.doubles(3, 0, 0.5).toArray(),
                        new double[] {0.4, 0.4, 0.4},
                        new double[3],
                        1 + random.nextInt(100));
        return new LitPoint(
                new double[] {0, 0, 1},
                above(random),
                above(random),
                random.nextDouble(0, 2),
                material,
                LightSource.white().attenuated(Attenuation.bySquare(1)),
                dim);
    }

    /** A direction of length 1 with z above 0. */
    private static double[] above(Random random) {
        double z = random.nextDouble(0.05, 1);
        double turn = random.nextDouble(0, 2 * Math.PI);
        double aside = Math.sqrt(1 - z * z);
        return new double[] {aside * Math.cos(turn), aside * Math.sin(turn), z};
    }
}
