package rasterlab.engine.visibility.hidden;

import java.util.Random;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/** Triangles of one kind all over a cube, the same in every run, and pictures of them. */
final class ScatteredTriangles {
    /** Half of the cube's edge, in world units; a picture is twice as wide. */
    private static final double HALF = 100;

    private static final SphericalView CAMERA = new SphericalView(0.4, 1.1, 600);

    private ScatteredTriangles() {}

    /**
     * @param count of triangles
     * @param reach how far corners are from a triangle's middle along each axis, at most, in units
     */
    static Mesh mesh(int count, double reach, long seed) {
        var random = new Random(seed);
        var xyz = new double[9 * count];
        var faces = new int[count][];
        for (int k = 0; k < count; k++) {
            for (int axis = 0; axis < 3; axis++) {
                double middle = random.nextDouble(-HALF, HALF);
                for (int corner = 0; corner < 3; corner++)
                    xyz[9 * k + 3 * corner + axis] = middle + random.nextDouble(-reach, reach);
            }
            faces[k] = new int[] {3 * k, 3 * k + 1, 3 * k + 2};
        }
        return new Mesh(xyz, faces);
    }

    /** All in perspective, from outside. */
    static SurfaceView seen(Mesh mesh, int width, int height) {
        var fit = new PictureFit(width, height, height / (3.2 * HALF));
        return SurfaceView.of(mesh, CAMERA, Projection.PERSPECTIVE, fit);
    }
}
