package rasterlab.engine.plan;

import java.util.Arrays;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.sight.ScreenAreas;
import rasterlab.engine.sight.SightFacts;
import rasterlab.engine.visibility.OutlineFaces;

/**
 * The faces that a picture shows, most questions about which a sample answers.
 *
 * @param request whose scene it is
 * @param known of that scene
 * @param seen the sample
 * @param areas of the sample
 * @param fronts whether backs are left out
 */
record ShownFaces(
        RenderRequest request,
        KnownScene known,
        RequestView seen,
        ScreenAreas areas,
        boolean fronts) {

    static ShownFaces of(RenderRequest request, KnownScene known, boolean fronts) {
        SceneSample sample = known.sample();
        RequestView seen = sample.seen(request);
        return new ShownFaces(
                request, known, seen, sample.areas(seen, known.facts().closed()), fronts);
    }

    SightFacts facts() {
        return known.facts();
    }

    /** All faces. */
    RequestView all() {
        return areas.whole() ? seen : RequestView.of(request, request.width());
    }

    /** Which of some faces are drawn. */
    boolean[] drawn(RequestView faces) {
        return drawn(faces, 0);
    }

    /** Which of some faces are drawn for an eye whose direction has turned by so many radians. */
    boolean[] drawn(RequestView faces, double turn) {
        if (fronts) return OutlineFaces.andFronts(faces.viewed(), turn);
        var drawn = new boolean[faces.viewed().mesh().faceCount()];
        Arrays.fill(drawn, true);
        return drawn;
    }

    FaceLights lights(RequestView faces) {
        return new FaceLights(
                faces.scene(), faces.viewed(), request.look().terms(), request.look().sides());
    }
}
