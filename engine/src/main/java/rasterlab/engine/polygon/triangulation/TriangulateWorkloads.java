package rasterlab.engine.polygon.triangulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.StarPolygon;
import rasterlab.engine.study.Workload;

/** Polygons to measure, the same in every run; the size is the number of corners. */
final class TriangulateWorkloads {
    private static final long SEED = 1975;
    private static final int POLYGONS = 4;
    private static final double RADIUS = 500;

    private TriangulateWorkloads() {}

    static List<Workload<Points>> all() {
        return List.of(convex(8), star(16), convex(32), star(64), convex(128), star(256));
    }

    private static Workload<Points> convex(int size) {
        var inputs = new ArrayList<Points>();
        for (int i = 0; i < POLYGONS; i++) inputs.add(onACircle(size, RADIUS + i));
        return new Workload<>("convex-" + size, size, inputs);
    }

    private static Workload<Points> star(int size) {
        var random = new Random(SEED + size);
        var inputs = new ArrayList<Points>();
        for (int i = 0; i < POLYGONS; i++) inputs.add(StarPolygon.of(size, RADIUS, random));
        return new Workload<>("star-" + size, size, inputs);
    }

    private static Points onACircle(int corners, double radius) {
        var x = new double[corners];
        var y = new double[corners];
        for (int i = 0; i < corners; i++) {
            x[i] = radius * StrictMath.cos(2 * Math.PI * i / corners);
            y[i] = radius * StrictMath.sin(2 * Math.PI * i / corners);
        }
        return new Points(x, y);
    }
}
