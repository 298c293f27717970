package rasterlab.app.visibility;

import java.util.Optional;
import rasterlab.app.model.EmptyPicture;
import rasterlab.app.plan.least.PlannedPicture;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.Raster;

/**
 * A finished picture; nobody writes into it any more.
 *
 * @param nanos how long it took to make
 * @param refusal what the method said instead of drawing; the picture is then empty
 * @param lent the method whose depths the picture shows, because its own keeps none
 * @param planned by which plan the least picture was drawn; empty for a method's
 */
public record Picture(
        RenderRequest request,
        Raster raster,
        long nanos,
        Optional<String> refusal,
        Optional<String> lent,
        Optional<PlannedPicture> planned) {
    Picture(RenderRequest request, Raster raster, long nanos) {
        this(request, raster, nanos, Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** Whether every pixel has the background's colour. */
    boolean isEmpty() {
        return EmptyPicture.is(raster, request.scene().backgroundRgb());
    }

    Picture refused(String said) {
        return new Picture(request, raster, nanos, Optional.of(said), lent, planned);
    }

    /** The least picture in place of the one that was asked for. */
    static Picture of(RenderRequest request, PlannedPicture planned, long nanos) {
        return new Picture(
                request,
                planned.raster(),
                nanos,
                Optional.empty(),
                Optional.empty(),
                Optional.of(planned));
    }

    /** This picture with the depths of another method. */
    Picture lentBy(String method) {
        return new Picture(request, raster, nanos, refusal, Optional.of(method), planned);
    }
}
