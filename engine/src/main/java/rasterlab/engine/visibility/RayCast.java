package rasterlab.engine.visibility;

import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * The exact reference: one ray per pixel centre against every face, in world space and doubles.
 *
 * <p>It shares no step with the methods it judges: it never projects a vertex, but sends the ray
 * {@code o + t·d} from the eye and takes the smallest depth t at which it meets a face. The ray
 * passes 2⁻²⁰ pixel right of the centre and 2⁻³⁰ below it, so that a centre on a shared edge
 * belongs to the face on its right, then below.
 *
 * <p>Source: A. Appel, Some techniques for shading machine renderings of solids, AFIPS 1968.
 */
final class RayCast implements Visibility {
    private static final double RIGHT_OF_CENTRE = 0x1p-20;
    private static final double BELOW_CENTRE = 0x1p-30;

    @Override
    public void draw(ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        var targets = new RayTargets(view.mesh());
        var rays = new Rays(view);
        IntStream.range(0, out.height())
                .parallel()
                .forEach(
                        row -> {
                            Cancellation.check(cancelled);
                            castRow(row, rays, targets, paint.fill(), out);
                        });
    }

    private static void castRow(int row, Rays rays, RayTargets targets, int[] fill, Raster out) {
        double[] ray = new double[6];
        for (int x = 0; x < out.width(); x++) {
            rays.through(x + RIGHT_OF_CENTRE, row + BELOW_CENTRE, ray);
            int face = targets.nearest(ray, rays.nearest);
            if (face >= 0) out.argb()[row * out.width() + x] = fill[face];
        }
    }

    /** The rays of a view; t is depth z in eye space. */
    private static final class Rays {
        final double nearest;
        private final double[] eye = new double[3];
        private final double[] right;
        private final double[] up;
        private final double[] forward;
        private final double rho;
        private final boolean central;
        private final PictureFit fit;

        Rays(ViewedMesh view) {
            SphericalView camera = view.camera();
            double st = Math.sin(camera.thetaRadians());
            double ct = Math.cos(camera.thetaRadians());
            double sp = Math.sin(camera.phiRadians());
            double cp = Math.cos(camera.phiRadians());
            right = new double[] {-st, ct, 0};
            up = new double[] {-cp * ct, -cp * st, sp};
            forward = new double[] {-sp * ct, -sp * st, -cp};
            rho = camera.rho();
            for (int i = 0; i < 3; i++) eye[i] = -rho * forward[i];
            central = view.projection() == Projection.PERSPECTIVE;
            nearest = view.near();
            fit = view.fit();
        }

        /** Origin in ray[0..2], direction in ray[3..5]. */
        void through(double pixelX, double pixelY, double[] ray) {
            double u = fit.toPlaneX(pixelX);
            double v = fit.toPlaneY(pixelY);
            for (int i = 0; i < 3; i++) {
                double across = u * right[i] + v * up[i];
                ray[i] = central ? eye[i] : eye[i] + across;
                ray[3 + i] = central ? forward[i] + across / rho : forward[i];
            }
        }
    }
}
