package rasterlab.engine.transform.axis;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;

/** Points turned about a line from outside: {@code points} and the line; {@code points} out. */
final class AxisFormat extends Format<AxisRotation, AxisTurn, Images> {
    /** The most points whose steps one answer has. */
    private static final int MOST_STEPPED = 1_000_000;

    private static final Field<double[]> POINTS =
            Field.required("points", Shape.points(3, 0, Shape.MOST_POINTS));
    private static final Field<double[]> THROUGH = Field.required("through", Shape.numbers(3, 3));
    private static final Field<double[]> DIRECTION =
            Field.required("direction", Shape.numbers(3, 3));
    private static final Field<Double> DEGREES =
            Field.required("degrees", Shape.number()).in("degrees");
    private static final Field<?> TURNED =
            Field.required("points", Shape.list(Shape.numbersOrNull(3, 3)));

    AxisFormat(Topic<AxisRotation, AxisTurn, Images> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(POINTS, THROUGH, DIRECTION, DEGREES);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(TURNED);
    }

    @Override
    public String reads() {
        return """
            {"points":[[x,y,z],...], "through":[x,y,z], "direction":[l,m,n], \
            "degrees":a}""";
    }

    @Override
    public String answers() {
        return """
            {"points":[[x,y,z],...]}""";
    }

    @Override
    public AxisTurn read(Given given) {
        return new AxisTurn(
                given.get(THROUGH), given.get(DIRECTION), given.get(DEGREES), given.get(POINTS));
    }

    @Override
    protected Given given(AxisTurn turn) {
        return new Given()
                .with(POINTS, turn.points())
                .with(THROUGH, turn.through())
                .with(DIRECTION, turn.direction())
                .with(DEGREES, turn.degrees());
    }

    @Override
    public void write(AxisTurn input, Images turned, ValueSink out) throws IOException {
        out.points(TURNED.name(), turned.coordinates(), 3);
    }

    @Override
    protected void check(Call<AxisRotation> call, AxisTurn turn) {
        if (!call.steps()) return;
        call.stepped(SteppedAxisRotation.class);
        RecordedSteps.requireAtMost(MOST_STEPPED, "points", turn.points().length / 3);
    }

    /** One step by its words, and where it left the points. */
    private record Step(String text, double[] points) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("step", text);
            out.points("points", points, 3);
        }
    }

    /** {@inheritDoc} With steps the points are where the last one left them. */
    @Override
    protected Written answered(Call<AxisRotation> call, AxisTurn turn) {
        if (!call.steps()) return super.answered(call, turn);
        var walk =
                call.stepped(SteppedAxisRotation.class)
                        .walk(turn.through(), turn.direction(), turn.degrees(), turn.points());
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.text(), walk.points()));
        var turned = new Images(steps.get(steps.size() - 1).points(), 3);
        return answer(turn, turned, null, RecordedSteps.plain(steps));
    }
}
