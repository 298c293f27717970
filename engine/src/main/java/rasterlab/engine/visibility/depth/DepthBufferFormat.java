package rasterlab.engine.visibility.depth;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.DepthFormat;
import rasterlab.contract.DepthRange;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Stored depths from outside: a range and the depths of surfaces; their codes out. */
final class DepthBufferFormat extends Format<DepthFormat, DepthRows, StoredDepths> {
    private static final double NEAREST = 1e-100;
    private static final double FARTHEST = 1e100;
    private static final Field<Double> NEAR =
            Field.required(
                    "near", Shape.described(Shape.number(), Shape.number(NEAREST, FARTHEST)));
    private static final Field<Double> FAR =
            Field.optional("far", Shape.described(Shape.number(), Shape.number(NEAREST, FARTHEST)));
    private static final Field<double[]> DEPTHS =
            Field.required(
                    "depths",
                    Shape.described(
                            Shape.numbers(1, DepthRows.MOST_SURFACES),
                            Shape.list(
                                    "numbers",
                                    Shape.number(NEAREST, Double.MAX_VALUE),
                                    1,
                                    DepthRows.MOST_SURFACES)));
    private static final Field<double[]> TO =
            Field.optional(
                    "to",
                    Shape.described(
                            Shape.numbers(1, DepthRows.MOST_SURFACES),
                            Shape.list(
                                    "numbers",
                                    Shape.number(NEAREST, Double.MAX_VALUE),
                                    1,
                                    DepthRows.MOST_SURFACES)));
    private static final Field<Integer> PIXELS =
            Field.optional("pixels", Shape.whole(1, DepthRows.MOST_PIXELS));

    private static final Shape<?> WHOLES =
            Shape.list(Shape.whole(Integer.MIN_VALUE, Integer.MAX_VALUE));
    private static final Shape<?> NUMBERS = Shape.list(EitherShape.orNull(Shape.number()));
    private static final Field<?> CODES = Field.required("codes", WHOLES);
    private static final Field<?> STORED = Field.required("stored", NUMBERS);
    private static final Field<?> Z = Field.required("z", NUMBERS);
    private static final Field<?> SEPARABLE = Field.required("separable", NUMBERS);
    private static final Field<?> FRONT = Field.required("front", WHOLES);

    DepthBufferFormat(Topic<DepthFormat, DepthRows, StoredDepths> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(NEAR, FAR, DEPTHS, TO, PIXELS);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(CODES, STORED, Z, SEPARABLE, FRONT);
    }

    @Override
    public String reads() {
        return """
            {"near":z, "far":z, "depths":[z,...], "to":[z,...], "pixels":n}, no far plane \
            without far, one pixel without pixels; depths are those of surfaces in the first \
            pixel of a scan line, to those in the last, as depths without to""";
    }

    @Override
    public String answers() {
        return """
            {"codes":[...], "stored":[...], "z":[...], "separable":[...], "front":[...]}, \
            surface after surface, pixel after pixel; separable is how far behind a depth is \
            told apart, null where none up to far is; front is the surface left in each pixel""";
    }

    @Override
    public DepthRows read(Given given) {
        double[] depths = given.get(DEPTHS);
        double[] to = given.get(TO, depths);
        if (given.has(TO) && !given.has(PIXELS))
            throw new InvalidInput("/pixels", "missing, to needs it");
        RecordedSteps.requireAtMost(
                "/pixels",
                DepthRows.MOST_DEPTHS,
                "surfaces times pixels",
                (long) depths.length * given.get(PIXELS, 1));
        if (to.length != depths.length)
            throw new InvalidInput(
                    "/to",
                    "expected %d depths as /depths has, got %d"
                            .formatted(depths.length, to.length));
        try {
            return new DepthRows(
                    new DepthRange(given.get(NEAR), given.get(FAR, Double.POSITIVE_INFINITY)),
                    depths,
                    to,
                    given.get(PIXELS, 1));
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(DepthRows rows) {
        Given given =
                new Given()
                        .with(NEAR, rows.range().near())
                        .with(DEPTHS, rows.depths())
                        .with(TO, rows.to())
                        .with(PIXELS, rows.pixels());
        double far = rows.range().far();
        return Double.isInfinite(far) ? given : given.with(FAR, far);
    }

    @Override
    public void write(DepthRows rows, StoredDepths stored, ValueSink out) throws IOException {
        out.wholes(CODES.name(), stored.codes());
        writeDepths(stored, out);
        writeFront(stored, out);
    }

    private static void writeDepths(StoredDepths stored, ValueSink out) throws IOException {
        out.numbers(Z.name(), stored.depths());
    }

    private static void writeFront(StoredDepths stored, ValueSink out) throws IOException {
        out.name(FRONT.name());
        out.startArray();
        for (int pixel = 0; pixel < stored.pixels(); pixel++) out.whole(stored.front(pixel));
        out.endArray();
    }

    /**
     * {@inheritDoc} A method without steps is told so before it runs. What is told beyond the
     * output stands between its fields.
     */
    @Override
    protected Written answered(Call<DepthFormat> call, DepthRows rows) {
        Written steps = call.steps() ? steps(call, rows) : out -> {};
        StoredDepths stored = recorded(call, rows);
        var coding = (DepthCoding) call.method();
        double[] behind = DepthCell.behind(coding, rows);
        DepthCoding.RangeCodes codes = coding.over(rows.range());
        return out -> {
            out.wholes(CODES.name(), stored.codes());
            out.name(STORED.name());
            out.startArray();
            for (int code : stored.codes()) out.number(codes.stored(code));
            out.endArray();
            writeDepths(stored, out);
            out.numbers(SEPARABLE.name(), behind);
            writeFront(stored, out);
            steps.write(out);
        };
    }

    private record Step(int pixel, double sum, int code, double decision) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("pixel", pixel);
            out.number("sum", sum);
            out.whole("code", code);
            out.number("decision", decision);
        }
    }

    @Override
    protected Written steps(Call<DepthFormat> call, DepthRows rows) {
        SteppedDepth format = call.stepped(SteppedDepth.class);
        var lists = new ArrayList<List<Step>>();
        for (int s = 0; s < rows.surfaces(); s++) {
            var steps = new ArrayList<Step>();
            DepthWalk walk =
                    format.walk(rows.range(), rows.nearness(s), rows.perPixel(s), rows.pixels());
            do steps.add(new Step(walk.pixel(), walk.sum(), walk.code(), walk.decision()));
            while (walk.advance());
            lists.add(steps);
        }
        return RecordedSteps.decidingLists(format.decisionFormula(), lists);
    }
}
