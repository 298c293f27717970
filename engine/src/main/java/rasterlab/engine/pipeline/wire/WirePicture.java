package rasterlab.engine.pipeline.wire;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.paint.Veil;
import rasterlab.engine.pipeline.wire.MeshEdges.Edge;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;

/**
 * The edges of a mesh.
 *
 * <p>A pixel of an edge is seen where the method's picture shows the background, or where the edge
 * is not behind the plane of the face that is shown: it is in the plane of its own faces, and along
 * outlines before that of what half of its pixels show.
 */
public final class WirePicture {
    /** How far behind a plane an edge still counts as in it, as a share of its nearness. */
    private static final double IN_PLANE = 1e-6;

    /** Pixels of a dash, and of a gap. */
    private static final int DASH = 4;

    private static final int[] ALL_SEEN = {};

    private final ViewedMesh view;
    private final WireStyle style;
    private final Ink ink;
    private final Optional<Veil> veil;
    private final Raster out;
    private final ScreenEdge screen;

    /**
     * @param veil how lines fade with depth
     * @param out as large as the view's fit
     */
    public WirePicture(
            ViewedMesh view, WireStyle style, int backgroundRgb, Optional<Veil> veil, Raster out) {
        this.view = view;
        this.style = style;
        this.veil = veil;
        this.out = out;
        ink = Ink.on(backgroundRgb);
        screen = new ScreenEdge(view);
    }

    /**
     * Draws over the background; hidden parts first, so that no seen one is interrupted.
     *
     * @param hiding decides what hides what
     * @param cancelled asked at least once per face or row, and once per edge
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public void draw(Visibility hiding, BooleanSupplier cancelled) {
        List<Edge> edges =
                new MeshEdges(view.mesh())
                        .all().stream()
                                .filter(e -> MeshEdges.shows(e, view, style.creaseDegrees()))
                                .toList();
        int[] faces = style.hidden() == HiddenLines.SHOWN ? ALL_SEEN : faces(hiding, cancelled);
        if (style.hidden() == HiddenLines.DASHED) draw(edges, faces, false, cancelled);
        draw(edges, faces, true, cancelled);
    }

    /** The face shown at each pixel, plus 1. */
    private int[] faces(Visibility hiding, BooleanSupplier cancelled) {
        var faces = new Raster(out.width(), out.height());
        faces.clear(FaceNumbers.BACKGROUND);
        hiding.draw(view, new FaceNumbers(), faces, cancelled);
        return faces.argb();
    }

    private void draw(List<Edge> edges, int[] faces, boolean seen, BooleanSupplier cancelled) {
        for (Edge edge : edges) {
            Cancellation.check(cancelled);
            if (screen.load(edge.from(), edge.to())) draw(edge, faces, seen);
        }
    }

    /** Draws the parts of an edge that are seen, or dashes along those that are not. */
    private void draw(Edge edge, int[] faces, boolean seen) {
        int steps = screen.steps();
        for (int step = 0; step <= steps; step++) {
            double t = screen.parameter(step);
            int x = (int) Math.rint(screen.x(t));
            int y = (int) Math.rint(screen.y(t));
            int shown = faces == ALL_SEEN ? FaceNumbers.BACKGROUND : faces[y * out.width() + x];
            if (sees(shown, t) != seen || !seen && step / DASH % 2 == 1) continue;
            int argb = seen ? ink.seen() : ink.hidden();
            out.argb()[y * out.width() + x] =
                    veil.isPresent() ? veil.get().over(argb, depth(t)) : argb;
        }
    }

    private double depth(double t) {
        return view.transform().central() ? 1 / screen.nearness(t) : -screen.nearness(t);
    }

    private boolean sees(int shown, double t) {
        if (shown == FaceNumbers.BACKGROUND) return true;
        double plane = planeNearness(shown - 1, screen.x(t), screen.y(t));
        return !(screen.nearness(t) < plane - IN_PLANE * Math.abs(plane));
    }

    /** From the plane n·p = k: as the z-buffer has it; not finite for a face seen edge-on. */
    private double planeNearness(int face, double pixelX, double pixelY) {
        double across =
                view.eyeNormal(face, 0) * view.fit().toPlaneX(pixelX)
                        + view.eyeNormal(face, 1) * view.fit().toPlaneY(pixelY);
        double nz = view.eyeNormal(face, 2);
        double k = view.planeOffset(face);
        return view.transform().central()
                ? (across / view.transform().distance() + nz) / k
                : (across - k) / nz;
    }
}
