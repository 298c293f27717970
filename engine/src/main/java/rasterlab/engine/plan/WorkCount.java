package rasterlab.engine.plan;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.sight.LightWork;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.NearnessPlane;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The work of a picture, counted by going through its pixels once more: the same on every machine,
 * free of noise.
 *
 * <p>A fragment is a pixel that a face covers; it is lit and textured where the method paints all
 * (painters) or where it is nearer than what the pixel held (depths). Where light is mixed from
 * corners on some faces, the bound that tells which ones counts as light formulas, too.
 */
public final class WorkCount {
    private final RenderRequest request;
    private final BooleanSupplier cancelled;
    private final ViewedMesh view;
    private final Mesh mesh;
    private final LitFaces lit;
    private final boolean paintsAll;
    private final float[] nearest;
    private final Scene scene;
    private long clipped;
    private long faces;
    private long lights;
    private long fragments;
    private long pixelLights;
    private long texels;

    private WorkCount(RenderRequest request, BooleanSupplier cancelled) {
        this.request = request;
        this.cancelled = cancelled;
        RequestView seen = RequestView.of(request, request.width());
        view = seen.viewed();
        scene = seen.scene();
        mesh = view.mesh();
        lit = LitFaces.of(request, seen);
        paintsAll = lit.family() == Family.PAINTER;
        nearest = new float[request.width() * request.height()];
        Arrays.fill(nearest, Float.NEGATIVE_INFINITY);
    }

    /**
     * The work of a request's faces; edges, surfaces and second eyes are not counted.
     *
     * @param cancelled asked at each face, and at each row of one
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static PictureWork of(RenderRequest request, BooleanSupplier cancelled) {
        Cancellation.check(cancelled);
        var count = new WorkCount(request, cancelled);
        boolean[] drawn = count.lit.drawn();
        for (int f = 0; f < drawn.length; f++) if (drawn[f]) count.add(f);
        return new PictureWork(
                count.mesh.vertexCount(),
                count.clipped,
                count.faces,
                count.lights,
                count.fragments,
                count.pixelLights,
                count.texels,
                (long) request.width() * request.height(),
                count.lit.pairs());
    }

    private void add(int face) {
        Cancellation.check(cancelled);
        faces++;
        boolean atPixels = lit.light().atPixels()[face];
        if (lit.light().mixed()) lights += LightWork.BOUND;
        if (!atPixels) lights += lit.light().perCorner() ? mesh.cornerCount(face) : 1;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            double z = view.eyeZ(mesh.corner(face, k));
            if (z >= view.near() && z <= view.far()) continue;
            clipped++;
            break;
        }
        var plane = new NearnessPlane();
        if (!plane.load(view, face)) return;
        var polygon = new ScreenPolygon(view);
        polygon.load(view, face);
        int reads = scene.finish(face).texture().isPresent() ? lit.light().texelReads() : 0;
        polygon.fill(
                request.width(),
                request.height(),
                (y, from, to) -> {
                    Cancellation.check(cancelled);
                    fragments += to - from;
                    long seen = paintsAll ? to - from : nearer(plane, y, from, to);
                    if (atPixels) pixelLights += seen;
                    texels += reads * seen;
                });
    }

    private long nearer(NearnessPlane plane, int y, int from, int to) {
        long nearer = 0;
        for (int x = from; x < to; x++) {
            float here = (float) (plane.base + y * plane.perRow + x * plane.perColumn);
            int at = y * request.width() + x;
            if (here <= nearest[at]) continue;
            nearest[at] = here;
            nearer++;
        }
        return nearer;
    }
}
