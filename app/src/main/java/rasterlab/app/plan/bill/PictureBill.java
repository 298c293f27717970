package rasterlab.app.plan.bill;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import rasterlab.app.plan.CountedWork;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.Planner;
import rasterlab.engine.plan.StageTimes;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.range.Bounds;

/**
 * The work that was counted for a picture and the time that was measured, beside what was predicted
 * for it and the work of the least picture that is enough.
 *
 * @param counted stage by stage, beside its prediction
 * @param times measured stage by stage
 * @param plan by which the picture is drawn, or else the least picture of the same view
 */
public record PictureBill(CountedWork counted, StageTimes times, Plan plan) {
    /** The tolerance that {@code ./lab plan} has unless it is told another. */
    public static final Tolerance USUAL = new Tolerance(0.5, 2, 0);

    /** Milliseconds for which stages are measured, if two rounds take less. */
    private static final double BUDGET = 100;

    /**
     * A picture that is shown.
     *
     * @param request what is drawn
     * @param plan by which, if by one
     */
    public record BilledPicture(RenderRequest request, Optional<Plan> plan) {}

    /**
     * A stage of drawing.
     *
     * @param stage its key
     * @param counted how often; empty for what is done once whatever is drawn
     * @param estimated how often, by the prediction
     * @param measured milliseconds of processor time; empty where another stage's time has it
     * @param share of the picture's measured time, 0 to 1
     * @param predicted milliseconds of processor time by the prices of the count
     * @param planned how often in the least picture
     */
    public record BillRow(
            String stage,
            Optional<Long> counted,
            Optional<Long> estimated,
            Optional<Double> measured,
            double share,
            double predicted,
            Optional<Long> planned) {
        public BillRow {
            Bounds.require("share", share, 0, 1);
        }

        private boolean isEmpty() {
            return predicted == 0
                    && measured.orElse(0.0) == 0
                    && counted.orElse(0L) + estimated.orElse(0L) + planned.orElse(0L) == 0;
        }
    }

    /**
     * The bills of pictures that are shown one after the other.
     *
     * @param events runs what it is given on the one thread that uses them, in order
     * @param onFailure told what counting threw, on any thread
     */
    public static Bills<BilledPicture, PictureBill> bills(
            Executor events, Consumer<Throwable> onFailure) {
        var planner = new Planner();
        return new Bills<>(
                "bill", (picture, cancelled) -> of(picture, planner, cancelled), events, onFailure);
    }

    /**
     * Counts and times a picture and plans its view, unless a plan draws it; empty where the method
     * has no prices, or refuses.
     *
     * @param cancelled asked often while it counts
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static Optional<PictureBill> of(
            BilledPicture picture, Planner planner, BooleanSupplier cancelled) {
        RenderRequest request = picture.request();
        try {
            return CountedWork.of(request, picture.plan(), cancelled)
                    .map(
                            work ->
                                    new PictureBill(
                                            work,
                                            StageTimes.of(request, BUDGET, cancelled),
                                            picture.plan()
                                                    .orElseGet(
                                                            () -> planner.plan(request, USUAL))));
        } catch (IllegalArgumentException refused) {
            return Optional.empty();
        }
    }

    /** The stages that anything happens in, in the order in which a picture is made. */
    public List<BillRow> rows() {
        Map<String, Long> here = counted.work().stages();
        Map<String, Long> before = counted.estimate().stages();
        Map<String, Long> least = plan.cost().work().stages();
        var rows = new ArrayList<BillRow>();
        counted.milliseconds()
                .forEach(
                        (stage, predicted) ->
                                rows.add(
                                        new BillRow(
                                                stage,
                                                Optional.ofNullable(here.get(stage)),
                                                Optional.ofNullable(before.get(stage)),
                                                Optional.ofNullable(
                                                        times.milliseconds().get(stage)),
                                                times.share(stage),
                                                predicted,
                                                Optional.ofNullable(least.get(stage)))));
        rows.removeIf(BillRow::isEmpty);
        return rows;
    }
}
