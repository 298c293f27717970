package rasterlab.engine.pipeline;

import java.util.stream.IntStream;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The view of one eye on a request's scene.
 *
 * @param scene what is left of it after culling
 * @param viewed its mesh
 */
public record RequestView(Scene scene, ViewedMesh viewed) {

    /** The view of the eye in the middle. */
    public static RequestView of(RenderRequest request, int width) {
        return of(request, width, 0);
    }

    /**
     * The view of an eye beside it, on the same picture plane.
     *
     * @param width of the eye's picture in pixels
     * @param toTheRight how far, in world units
     */
    static RequestView of(RenderRequest request, int width, double toTheRight) {
        var whole = new RequestView(request.scene(), view(request, width, toTheRight));
        return request.look().cull() == Cull.NONE ? whole : culled(request, whole, toTheRight);
    }

    private static ViewedMesh view(RenderRequest request, int width, double toTheRight) {
        Scene scene = request.scene();
        PictureFit fit = PictureFit.of(width, request.height(), scene.pictureScale());
        return new ViewedMesh(
                scene.mesh(),
                new ViewTransform(request.camera(), request.projection(), toTheRight),
                fit.forEye(toTheRight),
                request.depth().near(),
                request.depth().far(),
                request.look().clipPlanes());
    }

    private static RequestView culled(RenderRequest request, RequestView whole, double eye) {
        ViewedMesh view = whole.viewed;
        int[] kept =
                IntStream.range(0, view.mesh().faceCount())
                        .filter(face -> request.look().cull().keeps(view.seenFromInside(face)))
                        .toArray();
        Scene rest = request.scene().only(kept);
        return new RequestView(rest, view(request.with(rest), view.fit().width(), eye));
    }
}
