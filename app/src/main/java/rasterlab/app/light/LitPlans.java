package rasterlab.app.light;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.plan.bill.Bills;
import rasterlab.app.plan.least.MagnifiedDifference;
import rasterlab.app.plan.least.PlanBill;
import rasterlab.app.plan.least.PlanDrawing;
import rasterlab.app.plan.least.PlannedPicture;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;

/**
 * Lights a body by the least light that is enough, beside the full one, and measures both when
 * nothing moves. One thread draws; all else is for the thread of the model.
 */
public final class LitPlans implements AutoCloseable {
    private final PlanDrawing drawing = new PlanDrawing();
    private final Bills<PlannedPicture, PlanBill> bills;
    private Optional<LitPlanRequest> last = Optional.empty();
    private Optional<PlannedPicture> newest = Optional.empty();
    private boolean dragging;

    private record LitPlanRequest(LightChoice choice, Scene body, RenderRequest request) {
        /** Whether the same is lit alike, maybe seen from elsewhere. */
        private boolean isLike(LightChoice other, Scene lit, int width, int height) {
            LightChoice here = other.with(choice.camera()).with(choice.line());
            return lit == body
                    && width == request.width()
                    && height == request.height()
                    && here.selecting(choice.selected()).equals(choice);
        }
    }

    /**
     * The least picture beside the full one.
     *
     * @param full by the light formula at each pixel
     * @param picture the least one
     * @param difference of both, magnified where that is wished
     */
    public record ComparedPictures(
            Raster full, PlannedPicture picture, MagnifiedDifference difference) {}

    LitPlans(Executor events, Consumer<Throwable> onFailure) {
        bills = PlanBill.bills(events, onFailure);
        bills.listen(
                found ->
                        found.bill()
                                .filter(bill -> found.current() && !bill.holds())
                                .ifPresent(bill -> drawing.refute(bill.trial().plan())));
    }

    /** The least picture's times and errors beside the full one's. */
    public Bills<PlannedPicture, PlanBill> bills() {
        return bills;
    }

    /**
     * @param body the choice's scene
     */
    ComparedPictures drawn(
            LightFrame frame,
            Scene body,
            Tolerance within,
            PictureMaker maker,
            BooleanSupplier cancelled) {
        RenderRequest asked = asked(frame, body);
        PlannedPicture picture = drawing.drawn(asked, within, maker, cancelled);
        Raster full = maker.picture(picture.plan().full().from(asked.camera()), cancelled);
        boolean magnified = frame.choice().least().magnified();
        var difference = MagnifiedDifference.of(full, picture.raster(), magnified);
        return new ComparedPictures(full, picture, difference);
    }

    /** The request of a frame; of the same light seen from elsewhere with the same scene. */
    private RenderRequest asked(LightFrame frame, Scene body) {
        LightChoice choice = frame.choice();
        if (last.filter(asked -> asked.isLike(choice, body, frame.width(), frame.height()))
                .isEmpty()) {
            RenderRequest request =
                    LitScene.request(
                            choice, body, ShadingMethod.PHONG, frame.width(), frame.height());
            last = Optional.of(new LitPlanRequest(choice, body, request));
        }
        return last.get().request().from(choice.camera());
    }

    /** Tells on the thread that draws which picture is shown. */
    void shown(LightFrame.DrawnFrame drawn) {
        drawn.least().ifPresent(pair -> drawing.shown(pair.picture()));
    }

    /** Measures the newest picture, unless it is one of a drag. */
    void accept(LightFrame.DrawnFrame drawn) {
        bills.cancel();
        newest = drawn.least().map(ComparedPictures::picture);
        if (!dragging) newest.ifPresent(bills::ask);
    }

    void beginDrag() {
        dragging = true;
    }

    void endDrag() {
        dragging = false;
        if (!bills.current()) newest.ifPresent(bills::ask);
    }

    /** Waits until what was asked so far is measured or dropped. Any other thread. */
    void settle() throws InterruptedException {
        bills.settle();
    }

    @Override
    public void close() {
        bills.close();
    }
}
