package rasterlab.engine.visibility.depth;

import java.util.List;
import rasterlab.contract.DepthRange;
import rasterlab.engine.study.Workload;

/** Rows of a floor and a wall in a street, from 1 to 1000 units away. */
final class DepthWorkloads {
    private static final DepthRange STREET = new DepthRange(1, 1000);

    private DepthWorkloads() {}

    static List<Workload<DepthRows>> all() {
        return List.of(street(64), street(512), street(4096));
    }

    private static Workload<DepthRows> street(int pixels) {
        return new Workload<>(
                "pixels-" + pixels,
                pixels,
                List.of(
                        new DepthRows(
                                STREET, new double[] {2, 700}, new double[] {600, 750}, pixels)));
    }
}
