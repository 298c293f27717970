package rasterlab.engine.visibility.hidden;

import java.util.Random;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.FlatPaint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.exact.ExactVisibility;

/** Meshes on which methods disagree, and pictures whose colours are the numbers of faces. */
public final class TestScenes {
    private TestScenes() {}

    /** Triangles through each other, within 150 units and their reach of the origin. */
    public static Mesh crossing(int count, double reach, long seed) {
        var random = new Random(seed);
        double[] xyz = new double[9 * count];
        int[][] faces = new int[count][];
        for (int k = 0; k < count; k++) {
            for (int axis = 0; axis < 3; axis++) {
                double middle = random.nextDouble(-150, 150);
                for (int corner = 0; corner < 3; corner++)
                    xyz[9 * k + 3 * corner + axis] = middle + random.nextDouble(-reach, reach);
            }
            faces[k] = new int[] {3 * k, 3 * k + 1, 3 * k + 2};
        }
        return new Mesh(xyz, faces);
    }

    /** Three bars round the x axis, each over the next. */
    static Mesh cycle() {
        double[] xyz = new double[36];
        int[][] faces = new int[3][];
        double[] bar = {-151.3, 45.4, 60, 152.1, 45.4, -60, 152.1, 92.7, -60, -151.3, 92.7, 60};
        for (int b = 0; b < 3; b++) {
            double turn = 2 * Math.PI * b / 3 + 0.1;
            for (int k = 0; k < 4; k++) {
                int at = 12 * b + 3 * k;
                xyz[at] = bar[3 * k + 2];
                xyz[at + 1] = bar[3 * k] * Math.cos(turn) - bar[3 * k + 1] * Math.sin(turn);
                xyz[at + 2] = bar[3 * k] * Math.sin(turn) + bar[3 * k + 1] * Math.cos(turn);
            }
            faces[b] = new int[] {4 * b, 4 * b + 1, 4 * b + 2, 4 * b + 3};
        }
        return new Mesh(xyz, faces);
    }

    /** A box of six squares, turned outwards, and its edges from −half to half. */
    static Mesh box(double half) {
        double[] xyz = new double[24];
        for (int v = 0; v < 8; v++) {
            xyz[3 * v] = (v & 1) == 0 ? -half : half;
            xyz[3 * v + 1] = (v & 2) == 0 ? -half : half;
            xyz[3 * v + 2] = (v & 4) == 0 ? -half : half;
        }
        int[][] faces = {
            {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}
        };
        return new Mesh(xyz, faces);
    }

    public static ViewedMesh seen(
            Mesh mesh, SphericalView camera, Projection projection, int w, int h) {
        return new ViewedMesh(mesh, new ViewTransform(camera, projection), PictureFit.of(w, h, 1));
    }

    /** Each face in its number plus 1, over 0. */
    public static FlatPaint numbers(Mesh mesh) {
        int[] fill = new int[mesh.faceCount()];
        for (int f = 0; f < fill.length; f++) fill[f] = f + 1;
        return new FlatPaint(fill, new int[0]);
    }

    static Raster picture(String method, ViewedMesh view) {
        return picture(method, view, numbers(view.mesh()));
    }

    /** The picture by the reference. */
    static Raster exact(ViewedMesh view) {
        return exact(view, numbers(view.mesh()));
    }

    static Raster exact(ViewedMesh view, FacePaint paint) {
        var out = new Raster(view.fit().width(), view.fit().height());
        new ExactVisibility().draw(view, paint, out, () -> false);
        return out;
    }

    static Raster picture(String method, ViewedMesh view, FacePaint paint) {
        var out = new Raster(view.fit().width(), view.fit().height());
        new Visibilities().named(method).implementation().draw(view, paint, out, () -> false);
        return out;
    }
}
