package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Doubles;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.PointStep;
import rasterlab.engine.spline.SteppedPoint;

/** Points of a curve at given t, with the steps to each. */
final class CurvePointSteps {
    /** The most points that the steps of one answer leave. */
    private static final int MOST_LEFT = 1_000_000;

    private CurvePointSteps() {}

    static TopicRun.Answer answer(
            Watch watch, String method, CurveTracer tracer, Curve curve, double[] at) {
        if (!(tracer instanceof SteppedPoint stepped))
            throw Complaint.badInput(
                    "--steps: method '"
                            + method
                            + "' has none for points at given t; give a flatness");
        Steps.requireAtMost(MOST_LEFT, "points on the way to all t", mostLeft(curve, at.length));
        var points = new Doubles();
        List<List<PointStep>> steps = watch.call(method, () -> steps(stepped, curve, at, points));
        return json -> {
            CurveRun.writePoints(json, points);
            Steps.writeLists(json, steps, CurvePointSteps::write);
        };
    }

    /** What de Casteljau's triangle has, for each t; it takes lower degrees for cubics. */
    private static long mostLeft(Curve curve, int at) {
        long order = Math.max(curve.degree(), 3) + 1;
        return at * order * (order + 1) / 2;
    }

    private static List<List<PointStep>> steps(
            SteppedPoint method, Curve curve, double[] at, Doubles points) {
        var steps = new ArrayList<List<PointStep>>();
        for (double t : at) steps.add(method.stepsAt(curve, t));
        method.at(curve, at, (x, y) -> CurveRun.add(points, x, y));
        return steps;
    }

    private static void write(JsonGenerator json, PointStep step) throws IOException {
        json.writeStringField("step", step.text());
        JsonNumbers.writeField(json, "factor", step.factor());
        json.writeArrayFieldStart("points");
        for (int i = 0; i < step.x().length; i++)
            JsonNumbers.write(json, new double[] {step.x()[i], step.y()[i]});
        json.writeEndArray();
    }
}
