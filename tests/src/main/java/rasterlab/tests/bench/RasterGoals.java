package rasterlab.tests.bench;

import java.util.List;
import java.util.stream.Stream;

/** The goals of the raster methods. */
final class RasterGoals {
    private RasterGoals() {}

    static List<Goal> all() {
        return Stream.of(
                        ClipBenchmark.GOALS,
                        ClippedLineBenchmark.GOALS,
                        CurveBenchmark.GOALS,
                        LineBenchmark.GOALS,
                        OrientationBenchmark.GOALS,
                        PointInTriangleBenchmark.GOALS,
                        PolygonBenchmark.GOALS)
                .flatMap(List::stream)
                .toList();
    }
}
