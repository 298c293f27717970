package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.spline.curve.CurvatureComb;
import rasterlab.app.spline.curve.Joint;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.spline.plan.CurvePlan;
import rasterlab.engine.spline.plan.CurvePrices;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Topic;

/**
 * The drawings for one choice: both methods beside the exact curves.
 *
 * @param exact each curve as the topic's reference draws it, fine enough for a picture
 * @param other by the second method, if one is compared
 * @param plan the ways within the flatness; empty for given t, and where no method can do it
 * @param joints of all spans, in order; none where there are too many to be shown
 */
public record CurveDrawings(
        CurveChoice choice,
        List<Polyline> exact,
        CurveDrawing drawing,
        Optional<CurveDrawing> other,
        Optional<CurvePlan> plan,
        List<Joint> joints,
        CurvatureComb comb) {
    /** A picture's flatness as a share of the points' extent. */
    private static final double FINE = 1.0 / 4000;

    static CurveDrawings of(
            Topic<CurveTracer, CurveTask, Polyline> topic,
            CurveChoice choice,
            BooleanSupplier cancelled) {
        List<Curve> curves = choice.curves();
        Extent extent = choice.extent();
        var shown = new ArrayList<Polyline>();
        var wanted = new ArrayList<Polyline>();
        for (Curve curve : curves) {
            requireUse(cancelled);
            double flatness = Math.max(FINE * extent.diagonal(), 1e-99);
            shown.add(topic.exact(Sampling.flat(flatness).task(curve), CurveDrawing.LIMIT));
            requireUse(cancelled);
            wanted.add(topic.exact(choice.sampling().task(curve), CurveDrawing.LIMIT));
        }
        requireUse(cancelled);
        Optional<CurvePlan> plan = plan(choice, curves, wanted, cancelled);
        String method =
                plan.filter(found -> choice.planning().on())
                        .map(found -> found.chosen().method())
                        .orElse(choice.method());
        CurveDrawing drawing = CurveDrawing.of(topic, method, curves, choice.sampling(), wanted);
        requireUse(cancelled);
        Optional<CurveDrawing> other =
                Optional.of(choice.comparison())
                        .filter(name -> !name.isEmpty())
                        .map(
                                name ->
                                        CurveDrawing.of(
                                                topic, name, curves, choice.sampling(), wanted));
        return new CurveDrawings(
                choice,
                List.copyOf(shown),
                drawing,
                other,
                plan,
                Joint.all(curves),
                CurvatureComb.of(curves, extent.diagonal()));
    }

    private static Optional<CurvePlan> plan(
            CurveChoice choice,
            List<Curve> curves,
            List<Polyline> exact,
            BooleanSupplier cancelled) {
        if (!choice.sampling().isFlat()) return Optional.empty();
        try {
            return Optional.of(
                    CurvePlan.of(
                            curves.stream().map(choice.sampling()::task).toList(),
                            exact,
                            choice.planning().times(),
                            CurveDrawing.LIMIT,
                            CurvePrices.measured(),
                            cancelled));
        } catch (IllegalArgumentException | LimitReached none) {
            return Optional.empty(); // The drawing says why.
        }
    }

    private static void requireUse(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer choice was made");
    }
}
