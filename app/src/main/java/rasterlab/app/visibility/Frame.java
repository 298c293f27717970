package rasterlab.app.visibility;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.engine.pipeline.FaceDrawing;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.VisibilityWalk;

/**
 * The pictures that belong together.
 *
 * @param first by the chosen method
 * @param second by the other one
 * @param depths whether depths are shown instead of colours
 * @param steps how many steps of the method are made; {@link #ALL} for the whole picture
 */
record Frame(RenderRequest first, Optional<RenderRequest> second, boolean depths, int steps) {
    static final int ALL = Integer.MAX_VALUE;

    /** Behind depths: where no face is. */
    static final int NO_DEPTH = 0xFF16233B;

    /**
     * @param second empty for one picture
     */
    record Pictures(Picture first, Optional<Picture> second) {}

    Pictures made(PictureMaker maker, BooleanSupplier cancelled) {
        return new Pictures(
                picture(first, maker, cancelled),
                second.map(request -> picture(request, maker, cancelled)));
    }

    private Picture picture(RenderRequest request, PictureMaker maker, BooleanSupplier cancelled) {
        long start = System.nanoTime();
        try {
            Raster raster = drawn(request, maker, cancelled);
            return new Picture(request, raster, System.nanoTime() - start, Optional.empty());
        } catch (IllegalArgumentException refusal) {
            var empty = new Raster(request.width(), request.height());
            empty.clear(0xFF000000 | request.scene().backgroundRgb());
            return new Picture(request, empty, 0, Optional.of(refusal.getMessage()));
        }
    }

    private Raster drawn(RenderRequest request, PictureMaker maker, BooleanSupplier cancelled) {
        if (!depths && steps == ALL) return maker.picture(request, cancelled);
        Optional<FaceDrawing> drawing = FaceDrawing.of(request);
        if (drawing.isEmpty()) return maker.picture(request, cancelled);
        if (depths) return drawing.get().depths(steps, cancelled).picture(NO_DEPTH);
        if (!drawing.get().hasSteps()) return maker.picture(request, cancelled);
        return stepped(drawing.get(), cancelled);
    }

    private Raster stepped(FaceDrawing drawing, BooleanSupplier cancelled) {
        Raster out = drawing.blank();
        VisibilityWalk walk = drawing.walk(out);
        for (int i = 0; i < steps && walk.advance(); i++) Drawn.check(cancelled);
        return out;
    }
}
