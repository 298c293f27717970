package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.spline.curve.CurveWalk;
import rasterlab.engine.spline.curve.SteppedCurve;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Topic;

/**
 * The drawing of one method for the curves, point by point, beside the exact ones.
 *
 * @param points what it sent, of all curves in order; a joint's point once
 * @param splits how many pieces it halved
 * @param errorPixels how far it is off; not a number where it drew nothing
 * @param allowedPixels how far it may be off
 * @param right whether the topic calls it exact
 * @param message what the method said when it refused or failed; else ""
 */
public record CurveDrawing(
        String method,
        List<Corner> points,
        long splits,
        double errorPixels,
        double allowedPixels,
        boolean right,
        CurveEnding ending,
        String message) {
    /** The most points that the lab draws of a curve. */
    public static final int LIMIT = 20_000;

    /** How the drawing came to its end. */
    public enum CurveEnding {
        ENDED,
        /** The curve has more than {@link #LIMIT} points. */
        CUT,
        REFUSED,
        CRASHED
    }

    /**
     * One point that the method sent.
     *
     * @param t over all curves, from 0 to 1
     * @param decision see {@link SteppedCurve#decisionFormula}; not a number for given t
     */
    public record Corner(double t, double x, double y, double decision) {
        public Corner {
            Bounds.require("t", t, 0, 1);
        }
    }

    public CurveDrawing {
        points = List.copyOf(points);
    }

    public int segments() {
        return Math.max(0, points.size() - 1);
    }

    /**
     * @param exact of each curve, as the topic gives it for the sampling
     * @throws IllegalArgumentException if the topic has no method of that name
     */
    static CurveDrawing of(
            Topic<CurveTracer, CurveTask, Polyline> topic,
            String method,
            List<Curve> curves,
            Sampling sampling,
            List<Polyline> exact) {
        var making = new Making(topic, method, curves.size(), sampling);
        try {
            for (int i = 0; i < curves.size(); i++)
                making.add(i, sampling.task(curves.get(i)), exact.get(i));
            return making.drawing(CurveEnding.ENDED, "");
        } catch (LimitReached e) {
            return making.drawing(CurveEnding.CUT, e.getMessage());
        } catch (IllegalArgumentException e) {
            return making.nothing(CurveEnding.REFUSED, e.getMessage());
        } catch (RuntimeException e) {
            return making.nothing(CurveEnding.CRASHED, e.toString());
        }
    }

    private static final class Making {
        private final Topic<CurveTracer, CurveTask, Polyline> topic;
        private final String method;
        private final CurveTracer tracer;
        private final int curves;
        private final Sampling sampling;
        private final List<Corner> points = new ArrayList<>();
        private long splits;
        private double error;
        private double allowed;
        private boolean right = true;

        Making(
                Topic<CurveTracer, CurveTask, Polyline> topic,
                String method,
                int curves,
                Sampling sampling) {
            this.topic = topic;
            this.method = method;
            this.curves = curves;
            this.sampling = sampling;
            tracer = topic.method(method).implementation();
        }

        void add(int index, CurveTask task, Polyline exact) {
            var polyline = new Polyline(LIMIT);
            if (task.flatness() > 0 && tracer instanceof SteppedCurve stepped)
                walk(index, stepped.walk(task.curve(), task.flatness()), polyline);
            else if (task.flatness() > 0) flattened(index, task, polyline);
            else given(index, task, polyline);
            Deviation deviation = topic.compare(task, exact, polyline);
            error = Math.max(error, deviation.worst() * task.allowed());
            allowed = Math.max(allowed, task.allowed());
            right &= topic.correct(deviation);
        }

        private void walk(int index, CurveWalk walk, Polyline polyline) {
            while (walk.advance()) {
                polyline.point(walk.x(), walk.y());
                corner(index, walk.t(), walk.x(), walk.y(), walk.decision());
            }
            splits += walk.splits();
        }

        /** A method without steps tells no t: its points lie as if t grew evenly. */
        private void flattened(int index, CurveTask task, Polyline polyline) {
            tracer.flatten(task.curve(), task.flatness(), polyline::point);
            int last = Math.max(1, polyline.size() - 1);
            for (int i = 0; i < polyline.size(); i++)
                corner(index, (double) i / last, polyline.x(i), polyline.y(i), Double.NaN);
        }

        private void given(int index, CurveTask task, Polyline polyline) {
            tracer.at(
                    task.curve(),
                    task.at(),
                    (x, y) -> {
                        double t = sampling.at().get(Math.min(polyline.size(), sampling.steps()));
                        polyline.point(x, y);
                        corner(index, t, x, y, Double.NaN);
                    });
        }

        private void corner(int index, double t, double x, double y, double decision) {
            if (index > 0 && t == 0) return;
            points.add(new Corner((index + t) / curves, x, y, decision));
        }

        CurveDrawing drawing(CurveEnding ending, String message) {
            return new CurveDrawing(method, points, splits, error, allowed, right, ending, message);
        }

        CurveDrawing nothing(CurveEnding ending, String message) {
            return new CurveDrawing(
                    method, List.of(), 0, Double.NaN, allowed, false, ending, message);
        }
    }
}
