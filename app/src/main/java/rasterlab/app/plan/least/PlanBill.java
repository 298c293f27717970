package rasterlab.app.plan.least;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import rasterlab.app.plan.bill.Bills;
import rasterlab.engine.plan.PlanTrial;

/**
 * A least picture beside the full one: both timed in turns, and their difference.
 *
 * @param trial times and the difference within the tolerance
 * @param difference pixel by pixel
 */
public record PlanBill(PlanTrial trial, MagnifiedDifference difference) {
    /** Rounds of drawing both. */
    private static final int ROUNDS = 5;

    /**
     * The bills of least pictures that are shown one after the other.
     *
     * @param events runs what it is given on the one thread that uses them, in order
     * @param onFailure told what measuring threw, on any thread
     */
    public static Bills<PlannedPicture, PlanBill> bills(
            Executor events, Consumer<Throwable> onFailure) {
        return new Bills<>(
                "bill of the least picture",
                (picture, cancelled) -> Optional.of(of(picture, cancelled)),
                events,
                onFailure);
    }

    /**
     * @throws CancellationException soon after {@code cancelled} says true
     */
    static PlanBill of(PlannedPicture picture, BooleanSupplier cancelled) {
        var trial = PlanTrial.held(picture.plan(), picture.camera(), ROUNDS, cancelled);
        return new PlanBill(trial, MagnifiedDifference.of(trial.full(), trial.least(), true));
    }

    /** Whether the picture is within the tolerance of its plan. */
    public boolean holds() {
        return trial.error().within(trial.plan().tolerance());
    }
}
