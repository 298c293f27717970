package rasterlab.tests.bench;

import java.util.List;

/** What the raster methods should reach. */
final class RasterGoals {
    private RasterGoals() {}

    static List<Goal> all() {
        return List.copyOf(LineBenchmark.GOALS);
    }
}
