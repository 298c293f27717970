package rasterlab.engine.visibility.triangle;

import java.util.List;
import rasterlab.engine.study.Workload;

/** Two triangles that pass through each other and fill most of a square picture. */
final class DepthTriangleWorkloads {
    private DepthTriangleWorkloads() {}

    static List<Workload<DepthTriangles>> all() {
        return List.of(square(16), square(64), square(256));
    }

    private static Workload<DepthTriangles> square(int side) {
        double[] rising = {0, 0, 0.1, side, 0, 0.9, 0, side, 0.3};
        double[] falling = {side, 0, 0.2, side, side, 0.6, 0, 0, 0.8};
        return new Workload<>(
                "side-" + side,
                side * side,
                List.of(new DepthTriangles(List.of(rising, falling), side, side, 1)));
    }
}
