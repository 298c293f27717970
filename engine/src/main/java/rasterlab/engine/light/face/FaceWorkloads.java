package rasterlab.engine.light.face;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.study.Workload;

/** A shiny dome of ever more pixels, coarse as a sphere of 100 faces. */
final class FaceWorkloads {
    private static final double REACH = 0.2;

    private FaceWorkloads() {}

    static List<Workload<FacePoints>> all() {
        var workloads = new ArrayList<Workload<FacePoints>>();
        double[] lamp = {2, 1, 5};
        double[] eye = {-1, 0, 6};
        for (int rows : new int[] {3, 10, 30}) {
            var points =
                    FacePoints.grid(
                            FaceSamples.dome(REACH, lamp, eye, FaceSamples.gray(0.5, 0.4, 30)),
                            rows);
            workloads.add(
                    new Workload<>("pixels-" + points.count(), points.count(), List.of(points)));
        }
        return workloads;
    }
}
