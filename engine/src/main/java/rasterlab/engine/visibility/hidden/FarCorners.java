package rasterlab.engine.visibility.hidden;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * A square and a strip in the plane x = 0, seen by an eye that is a thousand times nearer to the
 * plane than their corners are to the eye: the plane's distance is a difference of large products.
 */
final class FarCorners {
    private static final double[] XYZ = {
        0, -1400, -1400, 0, 1400, -1400, 0, 1400, 1300, 0, -1400, 1300,
        0, -753, -657, 0, 757, 653, 0, 754, 655, 0, -755, -656
    };

    private FarCorners() {}

    /** The square comes first and so hides the strip. */
    static SurfaceView seen() {
        return SurfaceView.of(
                new Mesh(XYZ, new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}}),
                new SphericalView(0.7, Math.PI / 2, 1),
                Projection.PERSPECTIVE,
                new PictureFit(160, 120, 7));
    }
}
