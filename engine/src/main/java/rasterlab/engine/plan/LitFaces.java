package rasterlab.engine.plan;

import java.util.Arrays;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.sight.LightWork;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.visibility.OutlineFaces;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The faces that a picture draws and how each of them is lit, as its method and its shading say.
 *
 * @param method by which faces are hidden
 * @param fronts whether backs are left out
 * @param drawn faces
 * @param light of the faces
 */
record LitFaces(String method, boolean fronts, boolean[] drawn, LightWork light) {

    /** The faces of a request's view. */
    static LitFaces of(RenderRequest request, RequestView seen) {
        String method = Renderer.visibility(request).chosen();
        ViewedMesh view = seen.viewed();
        boolean pipeline = Family.of(method) == Family.PIPELINE;
        boolean few = pipeline && request.look().savings().frontsOnly();
        boolean fronts = few || method.equals("convex") && !view.cutsOpen();
        boolean[] drawn = few ? OutlineFaces.andFronts(view, 0) : drawn(view, fronts);
        ShadingMethod shading = ShadingMethod.named(Renderer.shading(request).chosen());
        double levels = request.look().savings().levels();
        boolean phong = shading == ShadingMethod.PHONG;
        boolean mixed = pipeline && phong && levels > 0;
        var atPixels = new boolean[drawn.length];
        if (mixed) {
            var light =
                    new FaceLights(
                            seen.scene(), view, request.look().terms(), request.look().sides());
            atPixels = new MixedLight(light, levels).atPixels(drawn);
        } else Arrays.fill(atPixels, phong);
        boolean perCorner = phong || shading == ShadingMethod.GOURAUD;
        var light = new LightWork(perCorner, atPixels, reads(request), mixed);
        return new LitFaces(method, fronts, drawn, light);
    }

    Family family() {
        return Family.of(method);
    }

    /** Pairs of faces that are compared. */
    long pairs() {
        long n = drawn.length;
        return method.equals("convex") ? 4 * n * n : 0;
    }

    private static boolean[] drawn(ViewedMesh view, boolean fronts) {
        var faces = new boolean[view.mesh().faceCount()];
        for (int f = 0; f < faces.length; f++) faces[f] = !fronts || !view.seenFromInside(f);
        return faces;
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
