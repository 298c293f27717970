package rasterlab.engine.sight;

import java.util.Optional;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.visibility.OutlineFaces;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * How many pixels each face of a view covers, estimated from its corners: the area of its outline
 * (the shoelace formula), at most that of its box within the picture. The faces may be a sample
 * that stands for more.
 */
public final class ScreenAreas {
    private final double[] area;
    private final boolean[] back;
    private final long pixels;
    private final double weight;
    private final int allVertices;
    private final boolean closed;
    private final ViewedMesh view;
    private Optional<boolean[]> fronts = Optional.empty();
    private int clipped;

    /** The areas of a closed body's faces, all of them. */
    public ScreenAreas(ViewedMesh view) {
        this(view, 1, view.mesh().vertexCount(), true);
    }

    /**
     * @param view of a sample of faces
     * @param weight how many faces each of them stands for, at least 1
     * @param allVertices of the mesh that the sample is taken from
     * @param closed whether fronts hide all backs
     */
    public ScreenAreas(ViewedMesh view, double weight, int allVertices, boolean closed) {
        Mesh mesh = view.mesh();
        PictureFit fit = view.fit();
        this.weight = weight;
        this.allVertices = allVertices;
        this.closed = closed;
        this.view = view;
        pixels = (long) fit.width() * fit.height();
        int vertices = mesh.vertexCount();
        double[] x = new double[vertices];
        double[] y = new double[vertices];
        for (int v = 0; v < vertices; v++) {
            double shrink =
                    view.transform().central() ? view.transform().distance() / view.eyeZ(v) : 1;
            x[v] = fit.toPixelX(view.eyeX(v) * shrink);
            y[v] = fit.toPixelY(view.eyeY(v) * shrink);
        }
        area = new double[mesh.faceCount()];
        back = new boolean[area.length];
        for (int f = 0; f < area.length; f++) {
            back[f] = view.seenFromInside(f);
            area[f] = area(view, f, x, y);
        }
    }

    private double area(ViewedMesh view, int face, double[] x, double[] y) {
        Mesh mesh = view.mesh();
        PictureFit fit = view.fit();
        double left = fit.width();
        double right = 0;
        double top = fit.height();
        double bottom = 0;
        double twice = 0;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int v = mesh.corner(face, k);
            int next = mesh.corner(face, (k + 1) % mesh.cornerCount(face));
            if (view.eyeZ(v) < view.near() || view.eyeZ(v) > view.far()) {
                clipped++;
                return pixels / 4.0;
            }
            twice += x[v] * y[next] - x[next] * y[v];
            left = Math.min(left, x[v]);
            right = Math.max(right, x[v]);
            top = Math.min(top, y[v]);
            bottom = Math.max(bottom, y[v]);
        }
        double wide = Math.min(right, fit.width()) - Math.max(left, 0);
        double high = Math.min(bottom, fit.height()) - Math.max(top, 0);
        if (wide <= 0 || high <= 0) return 0;
        return Math.min(Math.abs(twice) / 2, wide * high);
    }

    public int faces() {
        return area.length;
    }

    /** How many faces each of these stands for. */
    public double weight() {
        return weight;
    }

    /** Whether these are all faces. */
    public boolean whole() {
        return weight == 1;
    }

    /** Faces of the whole mesh. */
    public long allFaces() {
        return Math.round(weight * area.length);
    }

    public int vertices() {
        return allVertices;
    }

    /** Faces of the whole mesh that the near or the far plane may cut. */
    public long clipped() {
        return Math.round(weight * clipped);
    }

    /** Pixels of the picture. */
    public long pixels() {
        return pixels;
    }

    public double area(int face) {
        return area[face];
    }

    /** Whether a face shows its back. */
    public boolean back(int face) {
        return back[face];
    }

    /** Whether other faces hide a face, because it shows its back. */
    boolean hidden(int face) {
        return closed && back[face];
    }

    /** Whether a picture by depths that needs no backs can do without a face. */
    boolean spare(int face) {
        if (fronts.isEmpty()) fronts = Optional.of(OutlineFaces.andFronts(view, 0));
        return !fronts.get()[face];
    }
}
