package rasterlab.engine.transform.rotate;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.GrowingDoubles;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;

/** Turned points from outside: {@code points}, {@code degrees}, {@code times}; points out. */
public final class RotateFormat extends Format<PlaneRotation, Turns, Images> {
    /** The most turns, those of all points together, whose steps one answer has. */
    private static final int MOST_TURNS = 100_000;

    /** The most turns of all points together: some seconds. */
    private static final int MOST_WORK = 500_000_000;

    private static final String WORK = "points times turns";
    private static final Field<double[]> POINTS =
            Field.required("points", Shape.points(2, 0, Shape.MOST_POINTS)).as(FieldKind.POINTS);
    private static final Field<Double> DEGREES =
            Field.required("degrees", Shape.number()).in("degrees");
    private static final Field<Integer> TIMES =
            Field.optional("times", Shape.whole(0, PlaneRotation.MOST_TIMES));
    private static final Field<?> TURNED =
            Field.required("points", Shape.list(Shape.numbersOrNull(2, 2))).as(FieldKind.POINTS);

    public RotateFormat(Topic<PlaneRotation, Turns, Images> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(POINTS, DEGREES, TIMES);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(TURNED);
    }

    @Override
    public String reads() {
        return """
            {"points":[[x,y],...], "degrees":a, "times":n}, times being optional; points \
            times turns at most 500000000""";
    }

    @Override
    public String answers() {
        return """
            {"points":[[x,y],...]}""";
    }

    @Override
    public Turns read(Given given) {
        return new Turns(given.get(DEGREES), given.get(TIMES, 1), given.get(POINTS));
    }

    @Override
    protected Given given(Turns turns) {
        return new Given()
                .with(POINTS, turns.points())
                .with(DEGREES, turns.degrees())
                .with(TIMES, turns.times());
    }

    @Override
    public void write(Turns input, Images turned, ValueSink out) throws IOException {
        out.points(TURNED.name(), turned.coordinates(), 2);
    }

    @Override
    protected void check(Call<PlaneRotation> call, Turns turns) {
        long work = turns.points().length / 2L * turns.times();
        RecordedSteps.requireAtMost("/times", MOST_WORK, WORK, work);
        if (!call.steps()) return;
        call.stepped(SteppedRotation.class);
        RecordedSteps.requireAtMost(MOST_TURNS, WORK, work);
    }

    /** One formula of one turn, what it gave, and where the point was then. */
    private record Step(int turn, String text, double value, double x, double y)
            implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("turn", turn);
            out.text("step", text);
            out.number("value", value);
            out.numbers("point", x, y);
        }
    }

    /** {@inheritDoc} With steps the points are where the walks left them. */
    @Override
    protected Written answered(Call<PlaneRotation> call, Turns turns) {
        if (!call.steps()) return super.answered(call, turns);
        SteppedRotation stepped = call.stepped(SteppedRotation.class);
        double[] points = turns.points();
        var steps = new ArrayList<List<Step>>();
        var left = new GrowingDoubles();
        for (int i = 0; i < points.length; i += 2)
            steps.add(
                    drained(
                            stepped.walk(turns.degrees(), turns.times(), points[i], points[i + 1]),
                            left));
        return answer(turns, new Images(left.toArray(), 2), null, RecordedSteps.plainLists(steps));
    }

    private static List<Step> drained(TurnWalk walk, GrowingDoubles left) {
        var steps = new ArrayList<Step>();
        while (walk.advance())
            steps.add(new Step(walk.turn(), walk.text(), walk.value(), walk.x(), walk.y()));
        left.add(walk.x());
        left.add(walk.y());
        return steps;
    }
}
