package rasterlab.engine.transform.chain;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.study.Mutant;

/** Points sent through matrices with one mistake. */
final class TransformMutants {
    private static final PointTransformer RIGHT = new DoubleTransformer();

    private TransformMutants() {}

    static List<Mutant<PointTransformer>> all() {
        return List.of(
                new Mutant<>("last-matrix-first", "shift-then-turn", TransformMutants::backwards),
                new Mutant<>(
                        "points-as-columns",
                        "shift-in-the-last-row",
                        (dimension, matrices, points, h) ->
                                RIGHT.transform(dimension, transposed(matrices), points, h)),
                new Mutant<>("not-divided", "many-representations", TransformMutants::undivided),
                new Mutant<>(
                        "h-taken-for-1",
                        "many-representations",
                        (dimension, matrices, points, h) -> {
                            Arrays.fill(h, 1);
                            RIGHT.transform(dimension, matrices, points, h);
                        }),
                new Mutant<>(
                        "divided-by-absolute-h", "behind-the-eye", TransformMutants::dividedBySize),
                new Mutant<>(
                        "h-becomes-1",
                        "behind-the-eye",
                        (dimension, matrices, points, h) -> {
                            RIGHT.transform(dimension, matrices, points, h);
                            Arrays.fill(h, 1);
                        }),
                new Mutant<>("infinity-stays", "at-the-eye", TransformMutants::keptAtInfinity),
                new Mutant<>(
                        "coordinates-in-float",
                        "beyond-float",
                        (dimension, matrices, points, h) -> {
                            RIGHT.transform(dimension, matrices, points, h);
                            for (int i = 0; i < points.length; i++) points[i] = (float) points[i];
                        }));
    }

    private static void backwards(int dimension, double[][] matrices, double[] points, double[] h) {
        List<double[]> list = Arrays.asList(matrices.clone());
        Collections.reverse(list);
        RIGHT.transform(dimension, list.toArray(double[][]::new), points, h);
    }

    private static double[][] transposed(double[][] matrices) {
        var all = new double[matrices.length][];
        for (int m = 0; m < all.length; m++) {
            int size = (int) Math.sqrt(matrices[m].length);
            all[m] = new double[size * size];
            for (int i = 0; i < size * size; i++)
                all[m][i] = matrices[m][i % size * size + i / size];
        }
        return all;
    }

    private static void undivided(int dimension, double[][] matrices, double[] points, double[] h) {
        RIGHT.transform(dimension, matrices, points, h);
        for (int i = 0; i < points.length; i++) points[i] *= h[i / dimension];
    }

    private static void dividedBySize(
            int dimension, double[][] matrices, double[] points, double[] h) {
        RIGHT.transform(dimension, matrices, points, h);
        for (int i = 0; i < points.length; i++) points[i] *= Math.signum(h[i / dimension]);
    }

    private static void keptAtInfinity(
            int dimension, double[][] matrices, double[] points, double[] h) {
        double[] before = points.clone();
        RIGHT.transform(dimension, matrices, points, h);
        for (int i = 0; i < points.length; i++) if (h[i / dimension] == 0) points[i] = before[i];
    }
}
