package rasterlab.app.plan.least;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.PlanKeeper;
import rasterlab.engine.plan.Planner;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.plan.ToleratedDifference;
import rasterlab.engine.raster.Raster;

/**
 * Draws the least pictures of a camera that moves. A plan is kept as long as it holds. Where the
 * next one begins, its picture is held against the one that the plan before makes of the same view:
 * if they differ by more than the tolerance, which two plans may though neither errs, a full
 * picture, which both are near to, is shown between them.
 *
 * <p>One thread draws; another one may refute.
 */
public final class PlanDrawing {
    private final Planner planner = new Planner();
    private Optional<PlanKeeper> keeper = Optional.empty();
    private Optional<Tolerance> tolerance = Optional.empty();
    private Optional<PlannedPicture> last = Optional.empty();
    private final AtomicReference<Optional<Plan>> refuted = new AtomicReference<>(Optional.empty());

    /**
     * @param asked how it says it is drawn does not count
     * @throws IllegalArgumentException if the scene cannot be drawn
     */
    public PlannedPicture drawn(
            RenderRequest asked, Tolerance within, PictureMaker maker, BooleanSupplier cancelled) {
        Plan plan = plan(asked, within);
        Raster raster = maker.picture(plan.from(asked.camera()), cancelled);
        if (jumps(plan, raster, asked, maker, cancelled)) {
            plan = planner.nothingLeftOut(asked, within);
            raster = maker.picture(plan.from(asked.camera()), cancelled);
        }
        Plan by = plan;
        int before =
                last.filter(picture -> picture.plan() == by)
                        .map(PlannedPicture::pictures)
                        .orElse(0);
        return new PlannedPicture(plan, asked.camera(), raster, before + 1);
    }

    /** Tells which picture is shown: the next one must not differ from it too much. */
    public void shown(PlannedPicture picture) {
        last = Optional.of(picture);
    }

    /** Lets a plan that measuring found outside its tolerance, which no proof should allow, go. */
    public void refute(Plan plan) {
        refuted.set(Optional.of(plan));
    }

    private Plan plan(RenderRequest asked, Tolerance within) {
        if (keeper.isEmpty() || !tolerance.equals(Optional.of(within))) {
            keeper = Optional.of(new PlanKeeper(planner, within));
            tolerance = Optional.of(within);
        }
        Plan plan = keeper.get().plan(asked);
        return refuted.get().filter(wrong -> wrong == plan).isPresent()
                ? planner.nothingLeftOut(asked, within)
                : plan;
    }

    private boolean jumps(
            Plan plan,
            Raster raster,
            RenderRequest asked,
            PictureMaker maker,
            BooleanSupplier cancelled) {
        boolean changed = last.filter(picture -> picture.plan().isLike(plan)).isPresent();
        if (!changed || last.get().plan() == plan || !plan.saves()) return false;
        RenderRequest before = last.get().plan().least().from(asked.camera());
        return !ToleratedDifference.of(maker.picture(before, cancelled), raster, plan.tolerance())
                .within(plan.tolerance());
    }
}
