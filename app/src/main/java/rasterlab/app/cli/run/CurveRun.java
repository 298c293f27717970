package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.cli.run.json.Doubles;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.spline.CurveTopic;
import rasterlab.engine.spline.CurveWalk;
import rasterlab.engine.spline.SteppedCurve;
import rasterlab.engine.study.Topic;

/**
 * Topic {@code curve}: {@code kind}, {@code points} and either {@code at} or {@code flatness};
 * {@code points} out, and {@code segments}, how many lie between them.
 */
public final class CurveRun implements TopicRun {
    private static final int MOST = 1_000_000;
    private static final double SMALLEST = 1e-100;
    private static final double LARGEST = 1e100;
    private static final JsonField<String> KIND =
            JsonField.required("kind", json -> json.word(kinds()));
    private static final JsonField<double[]> POINTS =
            JsonField.required("points", json -> json.points(2, 1, MOST));
    private static final JsonField<double[]> AT =
            JsonField.optional("at", json -> json.numbers(1, MOST));
    private static final JsonField<Double> FLATNESS =
            JsonField.optional("flatness", StrictJson::number);

    private final Topic<CurveTracer, ?, ?> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    CurveRun(Watch watch) {
        this(watch, new CurveTopic());
    }

    CurveRun(Watch watch, Topic<CurveTracer, ?, ?> topic) {
        this.watch = watch;
        this.topic = topic;
    }

    private static List<String> kinds() {
        return Stream.of(Curve.Kind.values()).map(Curve.Kind::code).toList();
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"kind":KIND, "points":[[x,y],...]} with "at":[t,...] from 0 to 1 or \
                "flatness" in pixels, KIND being bezier, hermite (start, end, derivatives at \
                both), catmull-rom or b-spline""",
                """
                {"points":[[x,y],...], "segments":n}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, KIND, POINTS, AT, FLATNESS);
        if (given.has("at") == given.has("flatness"))
            throw Complaint.badInput(
                    "/: expected either at or flatness, got "
                            + (given.has("at") ? "both" : "neither"));
        given.find(AT).ifPresent(CurveRun::requireInside);
        given.find(FLATNESS).ifPresent(CurveRun::requireFlatness);
        Curve curve = curve(given.get(KIND), given.get(POINTS));
        CurveTracer tracer = topic.method(method).implementation();
        if (!steps) return watch.call(method, () -> traced(tracer, curve, given));
        if (given.has("at"))
            return CurvePointSteps.answer(watch, method, tracer, curve, given.get(AT));
        SteppedCurve stepped = Steps.of(method, tracer, SteppedCurve.class);
        return watch.call(method, () -> stepped(stepped, curve, given.get(FLATNESS)));
    }

    private static void requireInside(double[] at) {
        for (int i = 0; i < at.length; i++)
            if (at[i] < 0 || at[i] > 1)
                throw Complaint.badInput(
                        "/at/" + i + ": expected a number from 0 to 1, got " + at[i]);
    }

    private static void requireFlatness(double flatness) {
        if (flatness < SMALLEST || flatness > LARGEST)
            throw Complaint.badInput(
                    "/flatness: expected a number of pixels from %s to %s, got %s"
                            .formatted(SMALLEST, LARGEST, flatness));
    }

    private static Curve curve(String code, double[] coordinates) {
        Points points = Points.of(coordinates);
        try {
            Curve.Kind kind = Curve.Kind.values()[kinds().indexOf(code)];
            return new Curve(kind, points.xs(), points.ys());
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput("/" + e.getMessage().replaceFirst("\\[(\\d+)]", "/$1"));
        }
    }

    private static Answer traced(CurveTracer tracer, Curve curve, Given given) {
        var points = new Doubles();
        if (given.has("at")) tracer.at(curve, given.get(AT), (x, y) -> add(points, x, y));
        else tracer.flatten(curve, given.get(FLATNESS), (x, y) -> add(points, x, y));
        return json -> writePoints(json, points);
    }

    static void add(Doubles points, double x, double y) {
        points.add(x);
        points.add(y);
    }

    static void writePoints(JsonGenerator json, Doubles points) throws IOException {
        PointJson.write(json, points.toArray(), 2);
        json.writeNumberField("segments", points.size() / 2 - 1);
    }

    private record Step(double t, double x, double y, double decision) {
        void write(JsonGenerator json) throws IOException {
            JsonNumbers.writeField(json, "t", t);
            JsonNumbers.writeField(json, "x", x);
            JsonNumbers.writeField(json, "y", y);
            JsonNumbers.writeField(json, "decision", decision);
        }
    }

    private static Answer stepped(SteppedCurve stepped, Curve curve, double flatness) {
        var points = new Doubles();
        var steps = new ArrayList<Step>();
        CurveWalk walk = stepped.walk(curve, flatness);
        while (walk.advance()) {
            add(points, walk.x(), walk.y());
            steps.add(new Step(walk.t(), walk.x(), walk.y(), walk.decision()));
        }
        return json -> {
            writePoints(json, points);
            Steps.write(json, stepped.decisionFormula(), steps, (out, step) -> step.write(out));
        };
    }
}
