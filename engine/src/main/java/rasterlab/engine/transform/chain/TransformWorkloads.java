package rasterlab.engine.transform.chain;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;
import rasterlab.engine.transform.matrix.NamedMatrices;

/** Points through the house's kind of chain: scale, three turns, shift, perspective. */
final class TransformWorkloads {
    private static final long SEED = 2002;
    private static final int POINTS_PER_WORKLOAD = 4_096;

    private TransformWorkloads() {}

    static List<Workload<Chain>> all() {
        return List.of(points(1), points(16), points(256), points(4_096));
    }

    private static Workload<Chain> points(int count) {
        var random = new Random(SEED + count);
        var chains = new ArrayList<Chain>();
        for (int i = 0; i < POINTS_PER_WORKLOAD / Math.max(64, count); i++)
            chains.add(
                    new Chain(
                            3,
                            new double[][] {
                                cells("SCALE3D", 1 / 16.0),
                                cells("ROT3DX", random.nextDouble(-180, 180)),
                                cells("ROT3DY", random.nextDouble(-180, 180)),
                                cells("ROT3DZ", random.nextDouble(-180, 180)),
                                cells("TRANSL3D", 0, -150, 0),
                                cells("PERSPECTIVE", 0, 0, -1 / 700.0)
                            },
                            random.doubles(3L * count, 0, 10).toArray()));
        return new Workload<>("points-" + count, count, chains);
    }

    /** A named matrix row by row. */
    static double[] cells(String name, double... numbers) {
        double[][] rows = NamedMatrices.named(name).rows(numbers);
        var cells = new double[rows.length * rows.length];
        for (int i = 0; i < cells.length; i++) cells[i] = rows[i / rows.length][i % rows.length];
        return cells;
    }
}
