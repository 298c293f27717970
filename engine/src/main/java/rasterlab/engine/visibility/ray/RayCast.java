package rasterlab.engine.visibility.ray;

import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FaceBrush;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.PixelPoint;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * One ray per pixel against the faces, in world space and doubles.
 *
 * <p>It never projects a vertex, but sends the ray {@code o + t·d} from the eye through the {@link
 * PixelPoint} and takes the smallest depth t at which it meets a face, or where faces are
 * transparent all of them down to the first opaque one. {@link BoxTree} leaves out faces it cannot
 * meet.
 *
 * <p>Source: A. Appel, Some techniques for shading machine renderings of solids, AFIPS 1968, pp.
 * 37–45.
 */
public final class RayCast implements Visibility {
    @Override
    public VisibilityWork draw(
            ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        Cancellation.check(cancelled);
        var targets = new RayTargets(view.mesh());
        var boxes = new BoxTree(view.mesh());
        var rays = new Rays(view);
        return IntStream.range(0, out.height())
                .parallel()
                .mapToObj(
                        row -> {
                            Cancellation.check(cancelled);
                            var tally = new Tally();
                            var hits = new RayHits(targets, paint, new RaySpan(view), tally);
                            castRow(row, rays, boxes, hits, new FaceBrush(paint, out, tally), out);
                            return tally.work();
                        })
                .reduce(VisibilityWork.NONE, VisibilityWork::plus);
    }

    private static void castRow(
            int row, Rays rays, BoxTree boxes, RayHits hits, FaceBrush brush, Raster out) {
        double[] ray = new double[6];
        int[] seen = {};
        int from = 0;
        for (int x = 0; x < out.width(); x++) {
            rays.through(x + PixelPoint.RIGHT_OF_CENTER, row + PixelPoint.BELOW_CENTER, ray);
            hits.start(ray);
            boxes.cast(hits);
            if (hits.same(seen)) continue;
            paint(seen, row, from, x, brush);
            from = x;
            seen = hits.faces();
        }
        paint(seen, row, from, out.width(), brush);
    }

    private static void paint(int[] nearestFirst, int row, int from, int to, FaceBrush brush) {
        for (int i = nearestFirst.length - 1; i >= 0; i--)
            brush.span(nearestFirst[i], row, from, to);
    }

    /** The rays of a view; t is depth z in eye space. */
    private static final class Rays {
        private final double[][] axes = new double[3][3];
        private final double[] eye = new double[3];
        private final double distance;
        private final boolean central;
        private final PictureFit fit;

        Rays(ViewedMesh view) {
            ViewTransform transform = view.transform();
            for (int i = 0; i < 3; i++) {
                eye[i] = transform.toWorld(i, 0, 0, 0);
                axes[0][i] = transform.toWorld(i, 1, 0, 0) - eye[i];
                axes[1][i] = transform.toWorld(i, 0, 1, 0) - eye[i];
                axes[2][i] = transform.toWorld(i, 0, 0, 1) - eye[i];
            }
            distance = transform.distance();
            central = transform.central();
            fit = view.fit();
        }

        /** Sets the origin in ray[0..2], the direction in ray[3..5]. */
        void through(double pixelX, double pixelY, double[] ray) {
            double u = fit.toPlaneX(pixelX);
            double v = fit.toPlaneY(pixelY);
            for (int i = 0; i < 3; i++) {
                double across = u * axes[0][i] + v * axes[1][i];
                ray[i] = central ? eye[i] : eye[i] + across;
                ray[3 + i] = central ? axes[2][i] + across / distance : axes[2][i];
            }
        }
    }
}
