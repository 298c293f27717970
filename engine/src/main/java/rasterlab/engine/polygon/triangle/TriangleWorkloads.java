package rasterlab.engine.polygon.triangle;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.polygon.NearSides;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.study.Workload;

/** Triangles and points to measure, the same in every run. */
final class TriangleWorkloads {
    private static final long SEED = 2005;
    private static final int TRIANGLES = 8;
    private static final int PICTURE = 1000;

    private TriangleWorkloads() {}

    static List<Workload<ShapeAndPoints>> all() {
        return List.of(pixels(16), pixels(64), pixels(256), pixels(1024), nearSides(2048));
    }

    /** Whole numbers in a picture, half of the triangles going either way round. */
    private static Workload<ShapeAndPoints> pixels(int size) {
        var random = new Random(SEED + size);
        var inputs = new ArrayList<ShapeAndPoints>();
        for (int i = 0; i < TRIANGLES; i++) {
            Points corners = wholePoints(3, random);
            inputs.add(new ShapeAndPoints(corners, wholePoints(size, random)));
        }
        return new Workload<>("pixels-" + size, size, inputs);
    }

    /** Points rounded from places on the sides, so that only an exact sign can judge them. */
    private static Workload<ShapeAndPoints> nearSides(int size) {
        var random = new Random(SEED + size);
        var inputs = new ArrayList<ShapeAndPoints>();
        for (int i = 0; i < TRIANGLES; i++) {
            var corners = Points.of(random.doubles(6).map(v -> v * PICTURE).toArray());
            inputs.add(new ShapeAndPoints(corners, NearSides.of(corners, size, 2, random)));
        }
        return new Workload<>("near-sides-" + size, size, inputs);
    }

    private static Points wholePoints(int count, Random random) {
        return Points.of(random.ints(2L * count, 0, PICTURE).asDoubleStream().toArray());
    }
}
