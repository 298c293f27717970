package rasterlab.engine.pipeline.wire;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import rasterlab.engine.pipeline.paint.DepthFade;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.EyeSegment;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.ray.FaceCrossings;

/**
 * The edges of a mesh, and the lines in which its faces pass through each other.
 *
 * <p>A pixel of an edge is seen where the method's picture shows the background, or where {@link
 * EdgeSight} finds the edge not to be behind what is shown.
 */
public final class WirePicture {
    /** Pixels of a dash, and of a gap. */
    private static final int DASH = 4;

    private final ViewedMesh view;
    private final WireStyle style;
    private final WireColors ink;
    private final Optional<DepthFade> fade;
    private final Raster out;
    private final ScreenEdge screen;

    /**
     * @param fade how lines fade with depth
     * @param out as large as the view's fit
     */
    public WirePicture(
            ViewedMesh view,
            WireStyle style,
            int backgroundRgb,
            Optional<DepthFade> fade,
            Raster out) {
        this.view = view;
        this.style = style;
        this.fade = fade;
        this.out = out;
        ink = WireColors.on(backgroundRgb);
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
        List<EyeSegment> edges =
                Stream.concat(
                                MeshEdges.shown(view, style.creaseDegrees()),
                                FaceCrossings.of(view, cancelled).stream())
                        .toList();
        Optional<EdgeSight> sight =
                style.hidden() == HiddenLines.SHOWN
                        ? Optional.empty()
                        : Optional.of(new EdgeSight(view, faces(hiding, cancelled)));
        if (style.hidden() == HiddenLines.DASHED) draw(edges, sight, false, cancelled);
        draw(edges, sight, true, cancelled);
    }

    /** The face shown at each pixel, plus 1. */
    private int[] faces(Visibility hiding, BooleanSupplier cancelled) {
        var faces = new Raster(out.width(), out.height());
        faces.clear(FaceNumbers.BACKGROUND);
        hiding.draw(view, new FaceNumbers(), faces, cancelled);
        return faces.argb();
    }

    private void draw(
            List<EyeSegment> edges,
            Optional<EdgeSight> sight,
            boolean seen,
            BooleanSupplier cancelled) {
        for (EyeSegment edge : edges) {
            Cancellation.check(cancelled);
            if (screen.load(edge)) drawLoaded(sight, seen);
        }
    }

    /** Draws the parts of an edge that are seen, or dashes along those that are not. */
    private void drawLoaded(Optional<EdgeSight> sight, boolean seen) {
        int steps = screen.steps();
        for (int step = 0; step <= steps; step++) {
            double t = screen.parameter(step);
            int x = (int) Math.rint(screen.x(t));
            int y = (int) Math.rint(screen.y(t));
            if (sees(sight, t) != seen || !seen && step / DASH % 2 == 1) continue;
            int argb = seen ? ink.seen() : ink.hidden();
            out.argb()[y * out.width() + x] =
                    fade.isPresent() ? fade.get().over(argb, depth(t)) : argb;
        }
    }

    private double depth(double t) {
        return view.transform().central()
                ? view.transform().distance() / screen.nearness(t)
                : -screen.nearness(t);
    }

    /** Whether the edge is seen at t; without a sight everything is. */
    private boolean sees(Optional<EdgeSight> sight, double t) {
        return sight.isEmpty() || sight.get().sees(screen.x(t), screen.y(t), screen.nearness(t));
    }
}
