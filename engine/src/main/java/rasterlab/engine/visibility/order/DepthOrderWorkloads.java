package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;

/** Scattered triangles to measure, the same in every run; the size is their number. */
final class DepthOrderWorkloads {
    private static final long SEED = 1972;
    private static final double SIDE = 200;

    private DepthOrderWorkloads() {}

    static List<Workload<Sight>> all() {
        return List.of(scattered(2), scattered(3), scattered(4), scattered(6), scattered(8));
    }

    private static Workload<Sight> scattered(int cells) {
        int size = cells * cells * cells;
        var random = new Random(SEED + cells);
        var inputs = new ArrayList<Sight>();
        for (int i = 0; i < 2; i++)
            inputs.add(new Sight(triangles(cells, random), new double[] {300, -400, 350}));
        return new Workload<>("scattered-" + size, size, inputs);
    }

    /** One triangle in each cell of a cube round the origin: none touch. */
    static double[][] triangles(int cells, Random random) {
        var triangles = new double[cells * cells * cells][9];
        double cell = SIDE / cells;
        for (int k = 0; k < triangles.length; k++) {
            int[] place = {k % cells, k / cells % cells, k / cells / cells};
            for (int i = 0; i < 9; i++)
                triangles[k][i] = (place[i % 3] + random.nextDouble(0.02, 0.98)) * cell - SIDE / 2;
        }
        return triangles;
    }
}
