package rasterlab.app.coordinates.turn;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.rotate.SteppedRotation;
import rasterlab.engine.transform.rotate.TurnWalk;
import rasterlab.engine.transform.rotate.Turns;

/**
 * The chosen method's way round, and where every method ends.
 *
 * @param steps the way, formula by formula or turn by turn
 * @param exact where the point belongs in the end; not finite before anything is known
 * @param circle the way of the exact point
 * @param drifts of all methods in teaching order, the user's own last where it is chosen
 */
record TurnScene(
        TurnChoice choice,
        List<TurnStep> steps,
        StagePoint exact,
        List<StagePoint> circle,
        List<Drift> drifts) {
    /** The most turns whose way is kept. */
    static final int MOST_TURNS = 360;

    /** The chart's turns: powers of ten up to this one. */
    static final int CHARTED = 1_000_000;

    private static final int CIRCLE = 120;

    /**
     * A place on the way.
     *
     * @param turn from 1
     * @param formula what was computed, "" for a whole turn
     * @param value what that gave
     */
    record TurnStep(int turn, String formula, double value, StagePoint at) {
        TurnStep {
            Bounds.requireAtLeast("turn", turn, 1);
        }
    }

    /**
     * How one method does.
     *
     * @param end where the point is in the end; not finite where the method refuses
     * @param error of the end
     * @param samples the error after more and more turns; empty where the method refuses
     * @param refusal what it said then, in English; "" otherwise
     */
    record Drift(
            String method,
            StagePoint end,
            double error,
            boolean right,
            List<DriftSample> samples,
            String refusal) {
        boolean refused() {
            return !end.isFinite();
        }
    }

    /**
     * @param error largest difference of a coordinate over the point's larger one
     */
    record DriftSample(int times, double error) {}

    static TurnScene of(
            Topic<PlaneRotation, Turns, Images> topic,
            TurnChoice choice,
            BooleanSupplier cancelled) {
        var drifts = new ArrayList<Drift>();
        var methods = new ArrayList<>(topic.methods());
        if (choice.method().equals(OwnMethods.NAME)) methods.add(topic.method(OwnMethods.NAME));
        for (Method<PlaneRotation> method : methods) {
            if (cancelled.getAsBoolean()) throw new CancellationException();
            drifts.add(drift(topic, method, choice, cancelled));
        }
        return new TurnScene(
                choice,
                steps(topic, choice),
                spot(topic.exact(choice.turns(), 1)),
                circle(topic, choice),
                drifts);
    }

    private static Drift drift(
            Topic<PlaneRotation, Turns, Images> topic,
            Method<PlaneRotation> method,
            TurnChoice choice,
            BooleanSupplier cancelled) {
        try {
            Images end = topic.record(method.implementation(), choice.turns(), 1);
            Deviation off = deviation(topic, choice.turns(), end);
            var samples = new ArrayList<DriftSample>();
            for (int times = 1; times <= CHARTED; times *= 10) {
                if (cancelled.getAsBoolean()) throw new CancellationException();
                Turns turns = choice.turns(times);
                Images image = topic.record(method.implementation(), turns, 1);
                samples.add(new DriftSample(times, deviation(topic, turns, image).worst()));
            }
            return new Drift(
                    method.name(), spot(end), off.worst(), topic.correct(off), samples, "");
        } catch (IllegalArgumentException refused) {
            return new Drift(
                    method.name(),
                    new StagePoint(Double.NaN, Double.NaN),
                    Double.NaN,
                    false,
                    List.of(),
                    refused.getMessage());
        }
    }

    private static Deviation deviation(
            Topic<PlaneRotation, Turns, Images> topic, Turns turns, Images image) {
        return topic.compare(turns, topic.exact(turns, 1), image);
    }

    private static StagePoint spot(Images images) {
        return new StagePoint(images.coordinates()[0], images.coordinates()[1]);
    }

    private static List<TurnStep> steps(
            Topic<PlaneRotation, Turns, Images> topic, TurnChoice choice) {
        PlaneRotation method = topic.method(choice.method()).implementation();
        int turns = Math.min(choice.times(), MOST_TURNS);
        var steps = new ArrayList<TurnStep>();
        try {
            if (method instanceof SteppedRotation stepped) {
                TurnWalk walk = stepped.walk(choice.degrees(), turns, choice.x(), choice.y());
                while (walk.advance())
                    steps.add(
                            new TurnStep(
                                    walk.turn(),
                                    walk.text(),
                                    walk.value(),
                                    new StagePoint(walk.x(), walk.y())));
            } else {
                for (int turn = 1; turn <= turns; turn++)
                    steps.add(
                            new TurnStep(
                                    turn,
                                    "",
                                    Double.NaN,
                                    spot(topic.record(method, choice.turns(turn), 1))));
            }
        } catch (IllegalArgumentException refused) {
            return List.of();
        }
        return steps;
    }

    /** The images turned without drift. */
    private static List<StagePoint> circle(
            Topic<PlaneRotation, Turns, Images> topic, TurnChoice choice) {
        PlaneRotation method = topic.method("total-angle").implementation();
        var circle = new ArrayList<StagePoint>();
        for (int i = 0; i <= CIRCLE; i++) {
            var turns = new Turns(360.0 / CIRCLE, i, new double[] {choice.x(), choice.y()});
            circle.add(spot(topic.record(method, turns, 1)));
        }
        return circle;
    }

    /** A scene of which nothing is known yet. */
    static TurnScene before(TurnChoice choice) {
        return new TurnScene(
                choice, List.of(), new StagePoint(Double.NaN, Double.NaN), List.of(), List.of());
    }

    boolean known() {
        return exact.isFinite();
    }

    Drift drift() {
        return drifts.stream()
                .filter(each -> each.method().equals(choice.method()))
                .findFirst()
                .orElseThrow();
    }
}
