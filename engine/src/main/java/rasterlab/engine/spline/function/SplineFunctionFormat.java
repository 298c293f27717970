package rasterlab.engine.spline.function;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.MadeShape;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/**
 * Spline functions from outside: {@code x}, {@code y}, {@code ends}, {@code at}; {@code y} and
 * {@code coefficients} out, those of 1, s, s², s³ for each piece, s counted from the piece's knot.
 */
public final class SplineFunctionFormat
        extends Format<SplineFunction, SplineProblem, SplineValues> {
    private static final int MOST = 1_000_000;
    private static final Map<String, SplineEnds.Kind> KINDS =
            new TreeMap<>(
                    Map.of(
                            "slopes", SplineEnds.Kind.SLOPES,
                            "natural", SplineEnds.Kind.NATURAL,
                            "not-a-knot", SplineEnds.Kind.NOT_A_KNOT,
                            "periodic", SplineEnds.Kind.PERIODIC));
    private static final Field<double[]> X = Field.required("x", Shape.numbers(0, MOST));
    private static final Field<double[]> Y = Field.required("y", Shape.numbers(0, MOST));
    private static final Field<SplineEnds> ENDS = Field.optional("ends", new EndsShape());
    private static final Field<double[]> AT = Field.required("at", Shape.numbers(0, MOST));
    private static final Field<?> VALUES =
            Field.required("y", Shape.list(EitherShape.orNull(Shape.number())));
    private static final Field<?> COEFFICIENTS =
            Field.required("coefficients", Shape.list(Shape.numbersOrNull(4, 4)));
    private static final Field<?> NOTE = Field.optional("note", Shape.text());

    public SplineFunctionFormat(Topic<SplineFunction, SplineProblem, SplineValues> topic) {
        super(topic);
    }

    /** Ends by their kind, with the slopes where they are given. */
    private static final class EndsShape extends MadeShape<Given, SplineEnds> {
        private static final Field<String> KIND =
                Field.required("kind", Shape.word(List.copyOf(KINDS.keySet())));
        private static final Field<Double> LEFT = Field.optional("left", Shape.number());
        private static final Field<Double> RIGHT = Field.optional("right", Shape.number());

        EndsShape() {
            super(Shape.object(KIND, LEFT, RIGHT));
        }

        /** {@inheritDoc} Slopes have both, other kinds none but 0. */
        @Override
        public void schema(ValueSink out) throws IOException {
            Shape<String> others =
                    Shape.word(KINDS.keySet().stream().filter(k -> !k.equals("slopes")).toList());
            Shape<Double> none = Shape.number(0, 0);
            out.startObject();
            out.name("anyOf");
            out.startArray();
            Shape.object(
                            Field.required(KIND.name(), Shape.word(List.of("slopes"))),
                            Field.required(LEFT.name(), LEFT.shape()),
                            Field.required(RIGHT.name(), RIGHT.shape()))
                    .schema(out);
            Shape.object(
                            Field.required(KIND.name(), others),
                            Field.optional(LEFT.name(), none),
                            Field.optional(RIGHT.name(), none))
                    .schema(out);
            out.endArray();
            out.endObject();
        }

        @Override
        protected SplineEnds made(Given given) {
            SplineEnds.Kind kind = KINDS.get(given.get(KIND));
            for (Field<Double> slope : List.of(LEFT, RIGHT))
                if (kind == SplineEnds.Kind.SLOPES && !given.has(slope))
                    throw given.invalid(slope.name(), "missing; expected a finite number");
                else if (kind != SplineEnds.Kind.SLOPES && given.get(slope, 0.0) != 0)
                    throw given.invalid(
                            slope.name(),
                            "only ends of kind slopes have one, got " + given.get(slope));
            return new SplineEnds(kind, given.get(LEFT, 0.0), given.get(RIGHT, 0.0));
        }

        @Override
        protected Given value(SplineEnds ends) {
            String kind =
                    KINDS.keySet().stream()
                            .filter(name -> KINDS.get(name) == ends.kind())
                            .findFirst()
                            .orElseThrow();
            Given given = new Given().with(KIND, kind);
            return ends.kind() == SplineEnds.Kind.SLOPES
                    ? given.with(LEFT, ends.left()).with(RIGHT, ends.right())
                    : given;
        }
    }

    @Override
    public List<Field<?>> input() {
        return List.of(X, Y, ENDS, AT);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(VALUES, COEFFICIENTS, NOTE);
    }

    @Override
    public String reads() {
        return """
            {"x":[...], "y":[...], "ends":{"kind":KIND}, "at":[...]}, KIND being slopes \
            with "left" and "right", natural, not-a-knot or periodic; a method that keeps the shape \
            needs no ends and takes natural ones; periodic values may differ at the ends by \
            rounding, of which the answer's note tells""";
    }

    @Override
    public String answers() {
        return """
            {"y":[...], "coefficients":[[a,b,c,d],...]}, a + b*s + c*s^2 + d*s^3 for \
            each piece, and perhaps "note\"""";
    }

    /** {@inheritDoc} Natural ends where none are given. */
    @Override
    public SplineProblem read(Given given) {
        int knots = given.get(X).length;
        if (knots != given.get(Y).length)
            throw new InvalidInput(
                    "/y",
                    "expected %d %s as /x has, got %d"
                            .formatted(
                                    knots, knots == 1 ? "value" : "values", given.get(Y).length));
        return new SplineProblem(
                given.get(X),
                given.get(Y),
                given.get(ENDS, SplineEnds.natural()),
                given.get(AT),
                false);
    }

    @Override
    protected Given given(SplineProblem problem) {
        if (problem.shape())
            throw new IllegalArgumentException("that the shape counts is not told");
        return new Given()
                .with(X, problem.x())
                .with(Y, problem.y())
                .with(ENDS, problem.ends())
                .with(AT, problem.at());
    }

    /** {@inheritDoc} Methods that keep the shape alone take the slopes from the neighbours. */
    @Override
    public Supplier<Written> prepared(Call<SplineFunction> call, Given given) {
        SplineProblem problem = read(given);
        if (!given.has(ENDS) && call.method().promise() != SplineFunction.Promise.SHAPE)
            throw new InvalidInput("/ends", "missing; expected a JSON object with kind");
        return () -> answered(call, problem);
    }

    @Override
    public void write(SplineProblem problem, SplineValues values, ValueSink out)
            throws IOException {
        out.numbers(VALUES.name(), values.y());
    }

    /** {@inheritDoc} From outside the coefficients are told too. */
    @Override
    protected Written answered(Call<SplineFunction> call, SplineProblem problem) {
        SplineEnds ends = problem.ends();
        ClosedValues closed = ClosedValues.of(problem.y(), ends);
        double[] y = closed.values();
        Written steps = call.steps() ? steps(call, problem.x(), y, ends) : null;
        double[] coefficients = call.method().coefficients(problem.x(), y, ends);
        double[] values = new PiecewiseCubic(problem.x(), coefficients, ends).at(problem.at());
        return answer(
                problem,
                new SplineValues(call.method().promise(), coefficients.length, values),
                out -> {
                    out.points(COEFFICIENTS.name(), coefficients, 4);
                    if (closed.moved()) out.sentence(NOTE.name(), closed.note());
                },
                steps);
    }

    private record Step(String phase, int index, double decision) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("phase", phase);
            out.whole("index", index);
            out.number("decision", decision);
        }
    }

    private static Written steps(
            Call<SplineFunction> call, double[] x, double[] y, SplineEnds ends) {
        SteppedSpline stepped = call.stepped(SteppedSpline.class);
        var steps = new ArrayList<Step>();
        SplineWalk walk = stepped.walk(x, y, ends);
        while (walk.advance()) steps.add(new Step(walk.phase(), walk.index(), walk.decision()));
        return RecordedSteps.deciding(stepped.decisionFormula(), steps);
    }
}
