package rasterlab.engine.polygon.inside;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.polygon.NearSides;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.polygon.StarPolygon;
import rasterlab.engine.study.Workload;

/** Polygons and points to measure, the same in every run; the size is the number of corners. */
final class InsideWorkloads {
    private static final long SEED = 2001;
    private static final int POLYGONS = 4;
    private static final int POINTS = 200;
    private static final double RADIUS = 500;

    private InsideWorkloads() {}

    static List<Workload<ShapeAndPoints>> all() {
        return List.of(corners(4), corners(16), corners(64), corners(256), corners(1024));
    }

    /** Nine points of ten lie anywhere, one within two ulps of an edge. */
    private static Workload<ShapeAndPoints> corners(int size) {
        var random = new Random(SEED + size);
        var inputs = new ArrayList<ShapeAndPoints>();
        for (int i = 0; i < POLYGONS; i++) {
            Points polygon = StarPolygon.of(size, RADIUS, random);
            Points near = NearSides.of(polygon, POINTS / 10, 2, random);
            var xy = new double[2 * POINTS];
            for (int p = 0; p < POINTS; p++) {
                boolean anywhere = p >= near.size();
                xy[2 * p] = anywhere ? anywhere(random) : near.x(p);
                xy[2 * p + 1] = anywhere ? anywhere(random) : near.y(p);
            }
            inputs.add(new ShapeAndPoints(polygon, Points.of(xy)));
        }
        return new Workload<>("corners-" + size, size, inputs);
    }

    private static double anywhere(Random random) {
        return RADIUS * (2 * random.nextDouble() - 1);
    }
}
