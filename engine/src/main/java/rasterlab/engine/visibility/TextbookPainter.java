package rasterlab.engine.visibility;

import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;

/**
 * The painter's algorithm as the vase's coursework has it, faults included.
 *
 * <p>Eye coordinates are rounded to whole world units before ρ is added, a face's depth is the mean
 * z of its first three corners, screen corners are whole pixels, and the next face is searched
 * among all faces: N² comparisons. Ties keep the order of the mesh. The near plane is ours: the
 * coursework never divides by z and needs none.
 *
 * <p>Source: student's coursework "three-dimensional model of a vase", program listing. Its colours
 * also come from rounded coordinates; here every method gets the same colours.
 */
final class TextbookPainter implements Visibility {

    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public void draw(ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        double rho = view.transform().distance();
        double[] x = rounded(view.eyeX, 0);
        double[] y = rounded(view.eyeY, 0);
        double[] z = rounded(view.eyeZ, rho);
        double[] depth = depths(view, z);
        boolean[] drawn = new boolean[depth.length];
        var polygon = new ScreenPolygon(view.mesh().mostCorners());
        for (int pass = 0; pass < depth.length; pass++) {
            Cancellation.check(cancelled);
            int face = farthest(depth, drawn);
            drawn[face] = true;
            polygon.load(view, face, x, y, z);
            polygon.roundToPixels();
            FaceBrush.paint(polygon, face, paint, out);
        }
    }

    private static double[] rounded(double[] eye, double addedLast) {
        double[] rounded = new double[eye.length];
        for (int v = 0; v < eye.length; v++) rounded[v] = Math.rint(eye[v] - addedLast) + addedLast;
        return rounded;
    }

    private static double[] depths(ViewedMesh view, double[] z) {
        var mesh = view.mesh();
        double[] depth = new double[mesh.faceCount()];
        for (int f = 0; f < depth.length; f++)
            depth[f] = (z[mesh.corner(f, 0)] + z[mesh.corner(f, 1)] + z[mesh.corner(f, 2)]) / 3;
        return depth;
    }

    private static int farthest(double[] depth, boolean[] drawn) {
        int farthest = -1;
        for (int f = 0; f < depth.length; f++)
            if (!drawn[f] && (farthest < 0 || depth[f] > depth[farthest])) farthest = f;
        return farthest;
    }
}
