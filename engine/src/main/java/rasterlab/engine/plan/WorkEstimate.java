package rasterlab.engine.plan;

import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.sight.ScreenAreas;
import rasterlab.engine.sight.SightFacts;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The work of a picture as a planner predicts it: by the outlines of its faces, before any pixel is
 * drawn. {@link WorkCount} counts the same stages.
 */
public final class WorkEstimate {
    private WorkEstimate() {}

    /**
     * Predicts the work of a request's faces; edges, surfaces and second eyes are not predicted.
     *
     * @throws IllegalArgumentException if the scene cannot be drawn that way
     */
    public static PictureWork of(RenderRequest request) {
        RequestView seen = RequestView.of(request, request.width());
        LitFaces faces = LitFaces.of(request, seen);
        ViewedMesh view = seen.viewed();
        boolean closed = new SightFacts(seen.scene()).closed();
        var areas = new ScreenAreas(view, 1, view.mesh().vertexCount(), closed);
        boolean paintsAll = faces.family() == Family.PAINTER;
        return faces.light().estimate(areas, faces.fronts(), paintsAll, faces.pairs());
    }
}
