package rasterlab.engine.visibility.hidden;

import java.util.List;
import rasterlab.engine.study.Workload;

/** Scenes of more and more faces in one picture; the size is the number of faces. */
final class HiddenSurfacesWorkloads {
    private static final long SEED = 1974;
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;

    /** Reach of a single triangle: so many cover about as much as the picture has. */
    private static final double REACH = 400;

    private HiddenSurfacesWorkloads() {}

    static List<Workload<SurfaceView>> all() {
        return List.of(
                scattered(64), sphere(7), scattered(256), sphere(15), scattered(1024), sphere(31));
    }

    private static Workload<SurfaceView> scattered(int count) {
        var view =
                ScatteredTriangles.seen(
                        ScatteredTriangles.mesh(count, REACH / Math.sqrt(count), SEED),
                        WIDTH,
                        HEIGHT);
        return new Workload<>("scattered-" + count, count, List.of(view));
    }

    private static Workload<SurfaceView> sphere(int rings) {
        var mesh = SphereMesh.of(rings, 100);
        int faces = mesh.faceCount();
        return new Workload<>(
                "sphere-" + faces, faces, List.of(ScatteredTriangles.seen(mesh, WIDTH, HEIGHT)));
    }
}
