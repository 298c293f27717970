package rasterlab.engine.visibility.faces;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;

/** Spheres to measure, the same in every run; the size is the number of faces. */
final class VisibleFacesWorkloads {
    private static final long SEED = 1963;
    private static final int EYES = 4;

    private VisibleFacesWorkloads() {}

    static List<Workload<Body>> all() {
        return List.of(sphere(4), sphere(8), sphere(16), sphere(32), sphere(64));
    }

    private static Workload<Body> sphere(int meridians) {
        int faces = meridians * meridians / 2;
        var random = new Random(SEED + meridians);
        var inputs = new ArrayList<Body>();
        for (int i = 0; i < EYES; i++)
            inputs.add(
                    Bodies.sphere(
                            meridians,
                            meridians / 2,
                            100,
                            random.nextDouble(-400, 400),
                            random.nextDouble(-400, 400),
                            random.nextDouble(200, 400)));
        return new Workload<>("sphere-" + faces, faces, inputs);
    }
}
