package rasterlab.app.visibility;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.plan.least.PlanDrawing;
import rasterlab.app.plan.least.PlannedPicture;
import rasterlab.engine.pipeline.FaceDrawing;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.VisibilityWalk;

/**
 * The pictures that belong together.
 *
 * @param first by the chosen method
 * @param second by the other one
 * @param depths whether depths are shown instead of colours
 * @param steps how many steps of the method are made; {@link #ALL} for the whole picture
 * @param tolerance within which the least picture is drawn in place of the first; empty for that
 */
record Frame(
        RenderRequest first,
        Optional<RenderRequest> second,
        boolean depths,
        int steps,
        Optional<Tolerance> tolerance) {
    static final int ALL = Integer.MAX_VALUE;

    /** The colour behind depths: where no face is. */
    static final int NO_DEPTH = 0xFF16233B;

    /**
     * @param second empty for one picture
     */
    record FramePictures(Picture first, Optional<Picture> second) {}

    /**
     * @param plans draws the least picture
     */
    FramePictures made(PictureMaker maker, PlanDrawing plans, BooleanSupplier cancelled) {
        return new FramePictures(
                tolerance.isPresent()
                        ? least(tolerance.get(), maker, plans, cancelled)
                        : picture(first, maker, cancelled),
                second.map(request -> picture(request, maker, cancelled)));
    }

    private Picture picture(RenderRequest request, PictureMaker maker, BooleanSupplier cancelled) {
        long start = System.nanoTime();
        try {
            Optional<FaceDrawing> drawing = watched(request);
            Raster raster =
                    drawing.isPresent()
                            ? drawn(drawing.get(), cancelled)
                            : maker.picture(request, cancelled);
            var picture = new Picture(request, raster, System.nanoTime() - start);
            boolean lent = depths && drawing.filter(found -> !found.keepsDepths()).isPresent();
            return lent ? picture.lentBy(FaceDrawing.USUAL_BUFFER) : picture;
        } catch (IllegalArgumentException refusal) {
            return refused(request, refusal);
        }
    }

    private static Picture refused(RenderRequest request, IllegalArgumentException refusal) {
        var empty = new Raster(request.width(), request.height());
        empty.clear(0xFF000000 | request.scene().backgroundRgb());
        return new Picture(request, empty, 0).refused(refusal.getMessage());
    }

    private Picture least(
            Tolerance within, PictureMaker maker, PlanDrawing plans, BooleanSupplier cancelled) {
        long start = System.nanoTime();
        try {
            PlannedPicture made = plans.drawn(first, within, maker, cancelled);
            return Picture.of(first, made, System.nanoTime() - start);
        } catch (IllegalArgumentException refusal) {
            return refused(first, refusal);
        }
    }

    /**
     * The faces to watch; empty where the whole picture in its colours is wanted, or nothing else
     * can be had.
     */
    private Optional<FaceDrawing> watched(RenderRequest request) {
        if (!depths && steps == ALL) return Optional.empty();
        return FaceDrawing.of(request).filter(drawing -> depths || drawing.hasSteps());
    }

    private Raster drawn(FaceDrawing drawing, BooleanSupplier cancelled) {
        return depths
                ? drawing.depths(steps, cancelled).picture(NO_DEPTH)
                : stepped(drawing, cancelled);
    }

    private Raster stepped(FaceDrawing drawing, BooleanSupplier cancelled) {
        Raster out = drawing.blank();
        VisibilityWalk walk = drawing.walk(out);
        for (int i = 0; i < steps && walk.advance(); i++) Drawn.check(cancelled);
        return out;
    }
}
