package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.language.Complaints;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.spline.ClosedValues;
import rasterlab.engine.spline.PiecewiseCubic;
import rasterlab.engine.spline.SplineFunctionTopic;
import rasterlab.engine.spline.SplineWalk;
import rasterlab.engine.spline.SteppedSpline;
import rasterlab.engine.study.Topic;

/**
 * Topic {@code spline-function}: {@code x}, {@code y}, {@code ends}, {@code at}; {@code y} and
 * {@code coefficients} out, those of 1, s, s², s³ for each piece, s counted from the piece's knot.
 */
public final class SplineFunctionRun implements TopicRun {
    private static final int MOST = 1_000_000;
    private static final Map<String, SplineEnds.Kind> KINDS =
            new TreeMap<>(
                    Map.of(
                            "slopes", SplineEnds.Kind.SLOPES,
                            "natural", SplineEnds.Kind.NATURAL,
                            "not-a-knot", SplineEnds.Kind.NOT_A_KNOT,
                            "periodic", SplineEnds.Kind.PERIODIC));
    private static final JsonField<double[]> X =
            JsonField.required("x", json -> json.numbers(0, MOST));
    private static final JsonField<double[]> Y =
            JsonField.required("y", json -> json.numbers(0, MOST));
    private static final JsonField<double[]> AT =
            JsonField.required("at", json -> json.numbers(0, MOST));
    private static final JsonField<String> KIND =
            JsonField.required("kind", json -> json.word(List.copyOf(KINDS.keySet())));
    private static final JsonField<Double> LEFT = JsonField.optional("left", StrictJson::number);
    private static final JsonField<Double> RIGHT = JsonField.optional("right", StrictJson::number);
    private static final JsonField<SplineEnds> ENDS =
            JsonField.optional("ends", json -> ends(json.object(KIND, LEFT, RIGHT)));

    private final Topic<SplineFunction, ?, ?> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    SplineFunctionRun(Watch watch) {
        this(watch, new SplineFunctionTopic());
    }

    SplineFunctionRun(Watch watch, Topic<SplineFunction, ?, ?> topic) {
        this.watch = watch;
        this.topic = topic;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"x":[...], "y":[...], "ends":{"kind":KIND}, "at":[...]}, KIND being slopes \
                with "left" and "right", natural, not-a-knot or periodic; a method that keeps the shape \
                needs no ends and takes natural ones; periodic values may differ at the ends by \
                rounding, of which the answer's note tells""",
                """
                {"y":[...], "coefficients":[[a,b,c,d],...]}, a + b*s + c*s^2 + d*s^3 for \
                each piece, and perhaps "note\"""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, X, Y, ENDS, AT);
        if (given.get(X).length != given.get(Y).length)
            throw Complaint.badInput(
                    "/y: expected as many values as /x has, %d, got %d"
                            .formatted(given.get(X).length, given.get(Y).length));
        SplineFunction function = topic.method(method).implementation();
        SplineEnds ends = given.find(ENDS).orElseGet(() -> ends(function));
        ClosedValues values = ClosedValues.of(given.get(Y), ends);
        var data = new Data(given.get(X), values, ends, given.get(AT));
        return watch.call(method, () -> solved(method, function, data, steps));
    }

    /** The data that a method computes from. */
    private record Data(double[] x, ClosedValues closed, SplineEnds ends, double[] at) {
        double[] y() {
            return closed.values();
        }
    }

    /** The ends of a function whose slopes follow from its knots' neighbours. */
    private static SplineEnds ends(SplineFunction function) {
        if (function.promise() == SplineFunction.Promise.SHAPE) return SplineEnds.natural();
        throw Complaint.badInput("/ends: missing");
    }

    private static SplineEnds ends(Given given) {
        SplineEnds.Kind kind = KINDS.get(given.get(KIND));
        for (JsonField<Double> slope : List.of(LEFT, RIGHT))
            if (kind == SplineEnds.Kind.SLOPES && !given.has(slope.name()))
                throw Complaint.badInput("/ends/" + slope.name() + ": missing");
            else if (kind != SplineEnds.Kind.SLOPES && given.find(slope).orElse(0.0) != 0)
                throw Complaint.badInput(
                        "/ends/%s: only ends of kind slopes have one, got %s"
                                .formatted(slope.name(), given.get(slope)));
        return new SplineEnds(kind, given.find(LEFT).orElse(0.0), given.find(RIGHT).orElse(0.0));
    }

    private static Answer solved(String method, SplineFunction function, Data data, boolean steps) {
        List<Step> walked =
                steps ? steps(Steps.of(method, function, SteppedSpline.class), data) : List.of();
        double[] coefficients = function.coefficients(data.x(), data.y(), data.ends());
        double[] values = new PiecewiseCubic(data.x(), coefficients, data.ends()).at(data.at());
        return json -> {
            json.writeFieldName("y");
            JsonNumbers.write(json, values);
            json.writeFieldName("coefficients");
            JsonNumbers.writePoints(json, coefficients, 4);
            if (data.closed().moved())
                json.writeStringField("note", Complaints.saidToProgram(data.closed().note()));
            if (function instanceof SteppedSpline stepped && steps)
                Steps.write(
                        json, stepped.decisionFormula(), walked, (out, step) -> step.write(out));
        };
    }

    private record Step(String phase, int index, double decision) {
        void write(JsonGenerator json) throws IOException {
            json.writeStringField("phase", phase);
            json.writeNumberField("index", index);
            JsonNumbers.writeField(json, "decision", decision);
        }
    }

    private static List<Step> steps(SteppedSpline stepped, Data data) {
        var steps = new ArrayList<Step>();
        SplineWalk walk = stepped.walk(data.x(), data.y(), data.ends());
        while (walk.advance()) steps.add(new Step(walk.phase(), walk.index(), walk.decision()));
        return steps;
    }
}
