package rasterlab.engine.visibility;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.PictureFit;

/**
 * A z-buffer of floats that holds nearness: ρ/z in perspective, −z in parallel projection.
 *
 * <p>Both are linear in pixel coordinates over a plane, unlike z itself in perspective, so a face's
 * nearness is {@code base + x·perColumn + y·perRow} from its plane n·p = k. The larger nearness
 * wins; equal ones keep the earlier face.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974.
 */
final class FloatZBuffer implements Visibility {
    /** A larger buffer is not kept between frames, in pixels: a screen of 3840×2160 fits. */
    private static final int LARGEST_KEPT = 1 << 23;

    /** The buffer of the last frame, for the next one of the same size. */
    private final AtomicReference<float[]> spare = new AtomicReference<>(new float[0]);

    @Override
    public void draw(ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        float[] nearness = takeBuffer(out.argb().length);
        var polygon = new ScreenPolygon(view.mesh().mostCorners());
        var plane = new NearnessPlane();
        for (int face = 0; face < view.mesh().faceCount(); face++) {
            Cancellation.check(cancelled);
            if (!plane.load(view, face)) continue;
            polygon.load(view, face);
            fill(polygon, plane, face, paint, nearness, out);
        }
        if (nearness.length <= LARGEST_KEPT) spare.set(nearness);
    }

    private float[] takeBuffer(int pixels) {
        float[] last = spare.getAndSet(new float[0]);
        float[] buffer = last.length == pixels ? last : new float[pixels];
        Arrays.fill(buffer, Float.NEGATIVE_INFINITY);
        return buffer;
    }

    private static void fill(
            ScreenPolygon polygon,
            NearnessPlane plane,
            int face,
            FacePaint paint,
            float[] nearness,
            Raster out) {
        int width = out.width();
        polygon.fill(
                width,
                out.height(),
                (y, from, to) -> {
                    double rowBase = plane.base + y * plane.perRow;
                    int row = y * width;
                    int seenFrom = -1;
                    for (int x = from; x < to; x++) {
                        float here = (float) (rowBase + x * plane.perColumn);
                        boolean nearer = here > nearness[row + x];
                        if (nearer) nearness[row + x] = here;
                        if (nearer && seenFrom < 0) seenFrom = x;
                        if (nearer || seenFrom < 0) continue;
                        paint.span(face, y, seenFrom, x, out);
                        seenFrom = -1;
                    }
                    if (seenFrom >= 0) paint.span(face, y, seenFrom, to, out);
                });
    }

    /** Nearness over one face as a linear function of the pixel. */
    private static final class NearnessPlane {
        double base;
        double perColumn;
        double perRow;

        /**
         * With X, Y on the picture plane, n·p = k becomes ρ/z = (nx·X + ny·Y + nz·ρ)/k in
         * perspective and −z = (nx·X + ny·Y − k)/nz in parallel projection.
         *
         * @return false for a face seen exactly edge-on: it covers nothing
         */
        boolean load(ViewedMesh view, int face) {
            double nx = view.eyeNormal(face, 0);
            double ny = view.eyeNormal(face, 1);
            double nz = view.eyeNormal(face, 2);
            double k = view.planeOffset(face);
            boolean central = view.transform().central();
            double divisor = central ? k : nz;
            if (divisor == 0) return false;
            double perUnitX = nx / divisor;
            double perUnitY = ny / divisor;
            double middle = central ? nz * view.transform().distance() / k : -k / nz;
            PictureFit fit = view.fit();
            perColumn = perUnitX / fit.pixelsPerUnit();
            perRow = -perUnitY / fit.pixelsPerUnit();
            base = middle + perUnitX * fit.toPlaneX(0) + perUnitY * fit.toPlaneY(0);
            return true;
        }
    }
}
