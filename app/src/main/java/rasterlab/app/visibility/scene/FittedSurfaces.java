package rasterlab.app.visibility.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.visibility.hidden.SurfaceView;

/**
 * A scene of a picture whose size the tab's picture has not, made to fit the tab's.
 *
 * @param mesh as it is, or made higher
 * @param scale in pixels per unit of a picture of 800×600
 */
record FittedSurfaces(Mesh mesh, double scale, List<ShownDifference> differences) {
    /** Shares of the height that what is long and low is made to take of its width. */
    private static final double HIGHER = 0.5;

    private static final double LOW = 0.1;

    /**
     * @param reach pixels from the middle to the farthest corner
     */
    static FittedSurfaces of(SurfaceView input, double reach) {
        PictureFit fit = input.view().fit();
        var differences = new ArrayList<ShownDifference>();
        differences.add(
                ShownDifference.of(
                        ShownDifference.ShownDifferenceKind.PICTURE_SIZE,
                        fit.width(),
                        fit.height()));
        Mesh mesh = input.mesh();
        boolean central = input.view().transform().projection() == Projection.PERSPECTIVE;
        Matrix4d toEye = input.camera().matrix();
        double wide = 0;
        double high = 0;
        for (int v = 0; v < mesh.vertexCount(); v++) {
            var eye = toEye.transformPosition(new Vector3d(mesh.x(v), mesh.y(v), mesh.z(v)));
            double by = central ? input.camera().rho() / eye.z : 1;
            wide = Math.max(wide, Math.abs(eye.x) * by);
            high = Math.max(high, Math.abs(eye.y) * by);
        }
        if (high < LOW * wide) {
            double factor = Math.rint(HIGHER * wide / high);
            mesh = higher(mesh, factor);
            high *= factor;
            differences.add(
                    ShownDifference.of(ShownDifference.ShownDifferenceKind.STRETCHED, factor));
        }
        return new FittedSurfaces(mesh, reach / Math.max(wide, high), differences);
    }

    /**
     * The mesh made higher: seen level with the eye, height changes neither depths nor which face
     * is before which.
     */
    private static Mesh higher(Mesh mesh, double factor) {
        double[] xyz =
                IntStream.range(0, mesh.vertexCount())
                        .boxed()
                        .flatMapToDouble(
                                v -> DoubleStream.of(mesh.x(v), mesh.y(v), factor * mesh.z(v)))
                        .toArray();
        int[][] faces =
                IntStream.range(0, mesh.faceCount())
                        .mapToObj(
                                f ->
                                        IntStream.range(0, mesh.cornerCount(f))
                                                .map(c -> mesh.corner(f, c))
                                                .toArray())
                        .toArray(int[][]::new);
        return new Mesh(xyz, faces);
    }
}
