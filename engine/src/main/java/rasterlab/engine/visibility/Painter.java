package rasterlab.engine.visibility;

import java.util.Arrays;
import java.util.Comparator;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;

/**
 * The painter's algorithm: faces from the farthest to the nearest, each over the ones before.
 *
 * <p>Depth of a face is the mean z of all its corners in eye space; equal ones keep the order of
 * the mesh. A mean cannot order faces that overlap in depth, which is where this method errs.
 */
final class Painter implements Visibility {

    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public void draw(ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        var polygon = new ScreenPolygon(view.mesh().mostCorners());
        for (int face : farthestFirst(view)) {
            Cancellation.check(cancelled);
            polygon.load(view, face);
            FaceBrush.paint(polygon, face, paint, out);
        }
    }

    static int[] farthestFirst(ViewedMesh view) {
        double[] depth = new double[view.mesh().faceCount()];
        Arrays.setAll(depth, face -> meanZ(view, face));
        return IntStream.range(0, depth.length)
                .boxed()
                .sorted(Comparator.comparingDouble(face -> -depth[face]))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private static double meanZ(ViewedMesh view, int face) {
        int corners = view.mesh().cornerCount(face);
        double sum = 0;
        for (int k = 0; k < corners; k++) sum += view.eyeZ[view.mesh().corner(face, k)];
        return sum / corners;
    }
}
