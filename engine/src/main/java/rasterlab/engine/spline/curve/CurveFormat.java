package rasterlab.engine.spline.curve;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/**
 * Curves from outside: {@code kind}, {@code points} and either {@code at} or {@code flatness};
 * {@code points} out, and {@code segments}, how many lie between them.
 */
public final class CurveFormat extends Format<CurveTracer, CurveTask, Polyline> {
    private static final int MOST = 1_000_000;

    /** The most points that the steps of one answer leave. */
    private static final int MOST_LEFT = 1_000_000;

    private static final double SMALLEST = 1e-100;
    private static final double LARGEST = 1e100;
    private static final List<String> KINDS =
            Stream.of(Curve.Kind.values()).map(Curve.Kind::code).toList();
    private static final Field<String> KIND = Field.required("kind", Shape.word(KINDS));
    private static final Field<double[]> POINTS =
            Field.required(
                            "points",
                            Shape.described(
                                    Shape.points(2, 1, MOST),
                                    Shape.list(
                                            "points",
                                            Shape.boundedNumbers(2, -LARGEST, LARGEST),
                                            1,
                                            MOST)))
                    .as(FieldKind.POINTS);
    private static final Field<double[]> AT =
            Field.optional(
                    "at",
                    Shape.described(
                            Shape.numbers(1, MOST),
                            Shape.list("numbers", Shape.number(0, 1), 1, MOST)));
    private static final Field<Double> FLATNESS =
            Field.optional(
                            "flatness",
                            Shape.described(Shape.number(), Shape.number(SMALLEST, LARGEST)))
                    .in("pixels");
    private static final Field<?> TRACED =
            Field.required("points", Shape.list(Shape.numbersOrNull(2, 2))).as(FieldKind.POINTS);
    private static final Field<?> SEGMENTS =
            Field.required("segments", Shape.whole(-1, Integer.MAX_VALUE));

    public CurveFormat(Topic<CurveTracer, CurveTask, Polyline> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(KIND, POINTS, AT, FLATNESS);
    }

    @Override
    protected List<List<Field<?>>> groups() {
        return List.of(List.of(AT), List.of(FLATNESS));
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(TRACED, SEGMENTS);
    }

    @Override
    public String reads() {
        return """
            {"kind":KIND, "points":[[x,y],...]} with "at":[t,...] from 0 to 1 or \
            "flatness" in pixels, KIND being bezier, hermite (start, end, derivatives at \
            both), catmull-rom or b-spline""";
    }

    @Override
    public String answers() {
        return """
            {"points":[[x,y],...], "segments":n}""";
    }

    @Override
    public CurveTask read(Given given) {
        if (given.has(AT) == given.has(FLATNESS))
            throw new InvalidInput(
                    "/",
                    "expected either at or flatness, got " + (given.has(AT) ? "both" : "neither"));
        given.find(AT).ifPresent(CurveFormat::requireInside);
        given.find(FLATNESS).ifPresent(CurveFormat::requireFlatness);
        return new CurveTask(curve(given), given.get(AT, new double[0]), given.get(FLATNESS, 0.0));
    }

    @Override
    protected Given given(CurveTask task) {
        Given given =
                new Given()
                        .with(KIND, task.curve().kind().code())
                        .with(POINTS, new Points(task.curve().x(), task.curve().y()).numbers());
        return task.flatness() > 0
                ? given.with(FLATNESS, task.flatness())
                : given.with(AT, task.at());
    }

    private static void requireInside(double[] at) {
        for (int i = 0; i < at.length; i++)
            if (at[i] < 0 || at[i] > 1)
                throw new InvalidInput("/at/" + i, "expected a number from 0 to 1, got " + at[i]);
    }

    private static void requireFlatness(double flatness) {
        if (flatness < SMALLEST || flatness > LARGEST)
            throw new InvalidInput(
                    "/flatness",
                    "expected a number of pixels from %s to %s, got %s"
                            .formatted(SMALLEST, LARGEST, flatness));
    }

    private static Curve curve(Given given) {
        Points points = Points.of(given.get(POINTS));
        try {
            Curve.Kind kind = Curve.Kind.values()[KINDS.indexOf(given.get(KIND))];
            return new Curve(kind, points.xs(), points.ys());
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    public void write(CurveTask task, Polyline line, ValueSink out) throws IOException {
        out.name(TRACED.name());
        out.startArray();
        for (int i = 0; i < line.size(); i++) out.numbers(line.x(i), line.y(i));
        out.endArray();
        out.whole(SEGMENTS.name(), line.size() - 1);
    }

    @Override
    protected void check(Call<CurveTracer> call, CurveTask task) {
        if (!call.steps()) return;
        if (task.flatness() > 0) {
            call.stepped(SteppedCurve.class);
            return;
        }
        if (!(call.method() instanceof SteppedPoint))
            throw new InvalidInput(
                    "--steps",
                    "method '" + call.name() + "' has none for points at given t; give a flatness");
        RecordedSteps.requireAtMost(
                MOST_LEFT, "points on the way to all t", mostLeft(task.curve(), task.at().length));
    }

    /** The points of de Casteljau's triangle for all t; it takes lower degrees for cubics. */
    private static long mostLeft(Curve curve, int at) {
        long order = Math.max(curve.degree(), 3) + 1;
        return at * order * (order + 1) / 2;
    }

    @Override
    protected Written answered(Call<CurveTracer> call, CurveTask task) {
        if (call.steps())
            return task.flatness() > 0
                    ? flattened(call.stepped(SteppedCurve.class), task)
                    : traced(call.stepped(SteppedPoint.class), task);
        return answer(task, line(call.method(), task), null, null);
    }

    private static Polyline line(CurveTracer tracer, CurveTask task) {
        var line = new Polyline(Integer.MAX_VALUE);
        if (task.flatness() > 0) tracer.flatten(task.curve(), task.flatness(), line);
        else tracer.at(task.curve(), task.at(), line);
        return line;
    }

    private record Step(double t, double x, double y, double decision) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.number("t", t);
            out.number("x", x);
            out.number("y", y);
            out.number("decision", decision);
        }
    }

    private Written flattened(SteppedCurve stepped, CurveTask task) {
        var line = new Polyline(Integer.MAX_VALUE);
        var steps = new ArrayList<Step>();
        CurveWalk walk = stepped.walk(task.curve(), task.flatness());
        while (walk.advance()) {
            line.point(walk.x(), walk.y());
            steps.add(new Step(walk.t(), walk.x(), walk.y(), walk.decision()));
        }
        return answer(task, line, null, RecordedSteps.deciding(stepped.decisionFormula(), steps));
    }

    /** The points that one step to a point left. */
    private record Left(PointStep step) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("step", step.text());
            out.number("factor", step.factor());
            out.name("points");
            out.startArray();
            for (int i = 0; i < step.x().length; i++) out.numbers(step.x()[i], step.y()[i]);
            out.endArray();
        }
    }

    private Written traced(SteppedPoint stepped, CurveTask task) {
        var steps = new ArrayList<List<Left>>();
        for (double t : task.at())
            steps.add(stepped.stepsAt(task.curve(), t).stream().map(Left::new).toList());
        return answer(task, line(stepped, task), null, RecordedSteps.plainLists(steps));
    }
}
