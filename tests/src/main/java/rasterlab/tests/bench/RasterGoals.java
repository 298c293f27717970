package rasterlab.tests.bench;

import java.util.List;
import java.util.stream.Stream;

/** What the raster methods should reach. */
final class RasterGoals {
    private RasterGoals() {}

    static List<Goal> all() {
        return Stream.of(
                        LineBenchmark.GOALS,
                        ClippedLineBenchmark.GOALS,
                        CurveBenchmark.GOALS,
                        PolygonBenchmark.GOALS)
                .flatMap(List::stream)
                .toList();
    }
}
