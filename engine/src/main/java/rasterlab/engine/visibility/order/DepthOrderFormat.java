package rasterlab.engine.visibility.order;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Polygons in their order from outside: {@code polygons}, {@code eye}; {@code order} out. */
final class DepthOrderFormat extends Format<DepthOrder, Sight, Painting> {
    private static final int MOST_CORNERS = 1_000_000;
    private static final Shape<Integer> NUMBER = Shape.whole(0, Integer.MAX_VALUE);
    private static final Field<List<double[]>> POLYGONS =
            Field.required(
                    "polygons",
                    Shape.list("polygons", Shape.points(3, 3, MOST_CORNERS), 0, Shape.MOST_POINTS));
    private static final Field<double[]> EYE = Field.required("eye", Shape.numbers(3, 3));
    private static final Field<?> ORDER = Field.required("order", Shape.list(NUMBER));
    private static final Field<?> SPLITS =
            Field.required(
                    "splits",
                    Shape.list(
                            Shape.object(
                                    Field.required("polygon", NUMBER),
                                    Field.required(
                                            "corners", Shape.list(Shape.numbersOrNull(3, 3))))));

    DepthOrderFormat(Topic<DepthOrder, Sight, Painting> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(POLYGONS, EYE);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(ORDER, SPLITS);
    }

    @Override
    public String reads() {
        return """
            {"polygons":[[[x,y,z],...],...], flat and convex, "eye":[x,y,z]}""";
    }

    @Override
    public String answers() {
        return """
            {"order":[k,...] back to front, of n polygons below n a whole one and n + i \
            splits[i], "splits":[{"polygon":k, "corners":[[x,y,z],...]},...]}""";
    }

    @Override
    public Sight read(Given given) {
        return new Sight(given.get(POLYGONS).toArray(double[][]::new), given.get(EYE));
    }

    @Override
    protected Given given(Sight sight) {
        return new Given().with(POLYGONS, List.of(sight.polygons())).with(EYE, sight.eye());
    }

    /** Whether a piece is a polygon as given; one of no such polygon is none. */
    private static boolean isWhole(Painting.Piece piece, double[][] given) {
        int k = piece.polygon();
        return k >= 0 && k < given.length && piece.whole(given[k]);
    }

    /** {@inheritDoc} What is whole shows in the input. */
    @Override
    public void write(Sight sight, Painting painting, ValueSink out) throws IOException {
        double[][] given = sight.polygons();
        var splits = new ArrayList<Painting.Piece>();
        out.name(ORDER.name());
        out.startArray();
        for (Painting.Piece piece : painting.pieces())
            if (isWhole(piece, given)) out.whole(piece.polygon());
            else {
                out.whole(given.length + splits.size());
                splits.add(piece);
            }
        out.endArray();
        out.name(SPLITS.name());
        out.startArray();
        for (Painting.Piece piece : splits) {
            out.startObject();
            out.whole("polygon", piece.polygon());
            out.points("corners", piece.corners(), 3);
            out.endObject();
        }
        out.endArray();
    }

    @Override
    protected void check(Call<DepthOrder> call, Sight sight) {
        if (call.steps()) call.stepped(SteppedOrder.class);
    }

    @Override
    protected Written answered(Call<DepthOrder> call, Sight sight) {
        if (!call.steps()) return super.answered(call, sight);
        SteppedOrder stepped = call.stepped(SteppedOrder.class);
        var painting = new Painting();
        OrderWalk walk = stepped.walk(sight, painting::add);
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.step()));
        return answer(sight, painting, null, RecordedSteps.deciding(stepped.decision(), steps));
    }

    /** A polygon painted, moved or cut. */
    private record Step(OrderStep step) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole(step.kind().name().toLowerCase(Locale.ROOT), step.polygon());
            if (step.kind() == OrderStep.OrderStepKind.MOVE) out.whole("before", step.against());
            if (step.kind() == OrderStep.OrderStepKind.CUT) out.whole("by", step.against());
            out.number("decision", step.value());
        }
    }
}
