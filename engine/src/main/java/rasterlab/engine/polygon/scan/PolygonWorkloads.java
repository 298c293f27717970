package rasterlab.engine.polygon.scan;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.contract.FillRule;
import rasterlab.engine.study.Workload;

/** Polygons to measure: jagged stars in pictures of one size each, the same in every run. */
final class PolygonWorkloads {
    private static final long SEED = 1967;
    private static final int POLYGONS = 8;

    private PolygonWorkloads() {}

    static List<Workload<PolygonTask>> all() {
        return List.of(
                workload(16, 3),
                workload(64, 3),
                workload(64, 20),
                workload(256, 3),
                workload(256, 20),
                workload(256, 200));
    }

    private static Workload<PolygonTask> workload(int side, int corners) {
        var random = new Random(SEED + side + corners);
        var polygons = new ArrayList<PolygonTask>();
        for (int i = 0; i < POLYGONS; i++)
            polygons.add(star(side, corners, FillRule.values()[i % 2], random));
        return new Workload<>("side-" + side + "-corners-" + corners, side * side, polygons);
    }

    /** Corners at equal angles about the middle and at random distances from it. */
    private static PolygonTask star(int side, int corners, FillRule rule, Random random) {
        var x = new double[corners];
        var y = new double[corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            double distance = side / 2.0 * (0.3 + 0.7 * random.nextDouble());
            x[i] = side / 2.0 + distance * StrictMath.cos(angle);
            y[i] = side / 2.0 + distance * StrictMath.sin(angle);
        }
        return new PolygonTask(x, y, rule, side, side);
    }
}
