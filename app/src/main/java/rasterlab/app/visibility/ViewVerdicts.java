package rasterlab.app.visibility;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

/**
 * Finds in the background what every method does with the scene of a clicked view: exact where no
 * pixel of its picture differs from the exact one.
 */
final class ViewVerdicts implements AutoCloseable {
    private final PictureMaker maker = PictureMaker.by(new Renderer());
    private final LatestOnly<ViewVerdictRequest, Map<String, Verdict.Kind>> verdicts;

    /**
     * @param request of the view by any method, in the size of the stage
     */
    private record ViewVerdictRequest(
            RenderRequest request, Consumer<Map<String, Verdict.Kind>> listener) {}

    /**
     * @param events runs what it is given on the one thread that is told the verdicts
     * @param onFailure told what a method threw besides a refusal, on any thread
     */
    ViewVerdicts(Executor events, Consumer<Throwable> onFailure) {
        verdicts =
                new LatestOnly<>(
                        "verdicts",
                        (asked, cancelled) -> found(asked.request(), maker, cancelled),
                        (asked, found) -> events.execute(() -> asked.listener().accept(found)),
                        onFailure);
    }

    /** Tells the verdicts, method after method in teaching order, unless others are asked for. */
    void ask(RenderRequest request, Consumer<Map<String, Verdict.Kind>> told) {
        verdicts.ask(new ViewVerdictRequest(request, told));
    }

    /**
     * @throws CancellationException soon after {@code cancelled} says true
     */
    static Map<String, Verdict.Kind> found(
            RenderRequest request, PictureMaker maker, BooleanSupplier cancelled) {
        Raster exact = maker.picture(request.withVisibility(Renderer.REFERENCE), cancelled);
        var found = new LinkedHashMap<String, Verdict.Kind>();
        for (Method<?> method : Renderer.visibilityMethods())
            found.put(method.name(), verdict(request, method.name(), exact, maker, cancelled));
        return found;
    }

    private static Verdict.Kind verdict(
            RenderRequest request,
            String method,
            Raster exact,
            PictureMaker maker,
            BooleanSupplier cancelled) {
        try {
            Raster actual = maker.picture(request.withVisibility(method), cancelled);
            boolean right = PictureDifference.of(exact, actual).wrongPixels() == 0;
            return right ? Verdict.Kind.EXACT : Verdict.Kind.WRONG;
        } catch (IllegalArgumentException refused) {
            return Verdict.Kind.REFUSED; // The picture says why when the method is chosen.
        }
    }

    /** Ends the thread. */
    @Override
    public void close() {
        verdicts.close(maker::close);
    }
}
