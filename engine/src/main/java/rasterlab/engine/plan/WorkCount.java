package rasterlab.engine.plan;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.NearnessPlane;
import rasterlab.engine.visibility.OutlineFaces;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The work of a picture, counted by going through its pixels once more: the same on every machine,
 * free of noise.
 *
 * <p>A fragment is a pixel that a face covers; it is lit and textured where the method paints all
 * (painters) or where it is nearer than what the pixel held (depths).
 */
public final class WorkCount {
    private final RenderRequest request;
    private final BooleanSupplier cancelled;
    private final ViewedMesh view;
    private final Mesh mesh;
    private final boolean[] drawn;
    private final boolean[] atPixels;
    private final boolean paintsAll;
    private final boolean perCorner;
    private final float[] nearest;
    private final Scene scene;
    private final int readsOfTextured;
    private long clipped;
    private long faces;
    private long lights;
    private long fragments;
    private long pixelLights;
    private long texels;

    private WorkCount(RenderRequest request, String method, BooleanSupplier cancelled) {
        this.request = request;
        this.cancelled = cancelled;
        RequestView seen = RequestView.of(request, request.width());
        view = seen.viewed();
        scene = seen.scene();
        readsOfTextured = reads(request);
        mesh = view.mesh();
        boolean pipeline = Family.of(method) == Family.PIPELINE;
        drawn =
                pipeline && request.look().savings().frontsOnly()
                        ? OutlineFaces.andFronts(view, 0)
                        : drawn(method.equals("convex") && !view.cutsOpen());
        ShadingMethod shading = ShadingMethod.named(Renderer.shading(request).chosen());
        perCorner = shading == ShadingMethod.GOURAUD || shading == ShadingMethod.PHONG;
        double levels = request.look().savings().levels();
        if (pipeline && shading == ShadingMethod.PHONG && levels > 0) {
            var light =
                    new FaceLights(
                            seen.scene(), view, request.look().terms(), request.look().sides());
            atPixels = new MixedLight(light, levels).atPixels(drawn);
        } else {
            atPixels = new boolean[drawn.length];
            Arrays.fill(atPixels, shading == ShadingMethod.PHONG);
        }
        paintsAll = Family.of(method) == Family.PAINTER;
        nearest = new float[request.width() * request.height()];
        Arrays.fill(nearest, Float.NEGATIVE_INFINITY);
    }

    private boolean[] drawn(boolean fronts) {
        var faces = new boolean[mesh.faceCount()];
        for (int f = 0; f < faces.length; f++) faces[f] = !fronts || !view.seenFromInside(f);
        return faces;
    }

    /**
     * The work of a request's faces; edges, surfaces and second eyes are not counted.
     *
     * @param cancelled asked at each face, and at each row of one
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static PictureWork of(RenderRequest request, BooleanSupplier cancelled) {
        Cancellation.check(cancelled);
        String method = Renderer.visibility(request).chosen();
        var count = new WorkCount(request, method, cancelled);
        for (int f = 0; f < count.drawn.length; f++) if (count.drawn[f]) count.add(f);
        long n = count.mesh.faceCount();
        long pairs = method.equals("convex") ? 4 * n * n : 0;
        return new PictureWork(
                count.mesh.vertexCount(),
                count.clipped,
                count.faces,
                count.lights,
                count.fragments,
                count.pixelLights,
                count.texels,
                (long) request.width() * request.height(),
                pairs);
    }

    private void add(int face) {
        Cancellation.check(cancelled);
        faces++;
        if (!atPixels[face]) lights += perCorner ? mesh.cornerCount(face) : 1;
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
        int reads = scene.finish(face).texture().isPresent() ? readsOfTextured : 0;
        polygon.fill(
                request.width(),
                request.height(),
                (y, from, to) -> {
                    Cancellation.check(cancelled);
                    fragments += to - from;
                    long seen = paintsAll ? to - from : nearer(plane, y, from, to);
                    if (atPixels[face]) pixelLights += seen;
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

    private static int reads(RenderRequest request) {
        return switch (TextureMode.named(Renderer.texture(request).chosen())) {
            case NONE -> 0;
            case NEAREST, AFFINE_NEAREST -> 1;
            case LINEAR -> 4;
            case MIPMAP, AUTO -> 8;
        };
    }
}
