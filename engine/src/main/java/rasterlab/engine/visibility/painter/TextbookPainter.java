package rasterlab.engine.visibility.painter;

import java.util.function.IntToDoubleFunction;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FaceBrush;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;

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
final class TextbookPainter implements SteppedVisibility {

    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public String decision() {
        return "(z1 + z2 + z3) / 3 of corners rounded to whole units";
    }

    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        return new Walk(view, paint, out);
    }

    private static final class Walk implements VisibilityWalk {
        private final ViewedMesh view;
        private final double[] x;
        private final double[] y;
        private final double[] z;
        private final double[] depth;
        private final boolean[] drawn;
        private final ScreenPolygon polygon;
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private int pass;
        private int face;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            this.view = view;
            int vertices = view.mesh().vertexCount();
            x = rounded(vertices, view::eyeX, 0);
            y = rounded(vertices, view::eyeY, 0);
            z = rounded(vertices, view::eyeZ, view.transform().distance());
            depth = depths(view, z);
            drawn = new boolean[depth.length];
            polygon = new ScreenPolygon(view);
            brush = new FaceBrush(paint, out, tally);
        }

        @Override
        public boolean advance() {
            if (pass == depth.length) return false;
            pass++;
            tally.comparisons += depth.length;
            face = farthest(depth, drawn);
            drawn[face] = true;
            polygon.load(view, face, x, y, z);
            polygon.roundToPixels();
            brush.paint(polygon, face);
            return true;
        }

        @Override
        public VisibilityStep step() {
            return new VisibilityStep.FaceDrawn(face, depth[face]);
        }

        @Override
        public VisibilityWork work() {
            return tally.work();
        }
    }

    private static double[] rounded(int vertices, IntToDoubleFunction eye, double addedLast) {
        double[] rounded = new double[vertices];
        for (int v = 0; v < vertices; v++)
            rounded[v] = Math.rint(eye.applyAsDouble(v) - addedLast) + addedLast;
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
