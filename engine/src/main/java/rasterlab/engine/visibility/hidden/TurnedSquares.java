package rasterlab.engine.visibility.hidden;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * Two squares about one point in one plane, which was turned about z and then about x: rounding has
 * led the corners out of it, each by its own last bit.
 */
final class TurnedSquares {
    private static final double ABOUT_Z = 0.7;
    private static final double ABOUT_X = 0.4;
    private static final double[] HALVES = {50, 30};

    private TurnedSquares() {}

    /** The larger comes first and so hides the smaller, wherever the eye is. */
    static SurfaceView seen() {
        var xyz = new double[24];
        int at = 0;
        for (double half : HALVES)
            for (int corner = 0; corner < 4; corner++) {
                double x = corner == 1 || corner == 2 ? half : -half;
                double y = corner >= 2 ? half : -half;
                double across = x * Math.sin(ABOUT_Z) + y * Math.cos(ABOUT_Z);
                xyz[at++] = x * Math.cos(ABOUT_Z) - y * Math.sin(ABOUT_Z);
                xyz[at++] = across * Math.cos(ABOUT_X);
                xyz[at++] = across * Math.sin(ABOUT_X);
            }
        return SurfaceView.of(
                new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}}),
                new SphericalView(Math.PI / 6, Math.PI / 3, 400),
                Projection.PERSPECTIVE,
                new PictureFit(60, 45, 0.3));
    }
}
