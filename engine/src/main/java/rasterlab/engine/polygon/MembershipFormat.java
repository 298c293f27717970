package rasterlab.engine.polygon;

import java.io.IOException;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/**
 * Formats of topics on points inside of something have this in common: {@code points}; {@code
 * inside} out, true or false for each.
 *
 * @param <C> the contract that methods implement
 */
public abstract class MembershipFormat<C> extends Format<C, ShapeAndPoints, Membership> {
    protected static final Field<double[]> POINTS =
            Field.required("points", Shape.points(2, 0, Shape.MOST_POINTS)).as(FieldKind.POINTS);
    private static final Field<?> INSIDE =
            Field.required("inside", Shape.list(Shape.flag())).as(FieldKind.CHOICE);

    protected MembershipFormat(Topic<C, ShapeAndPoints, Membership> topic) {
        super(topic);
    }

    @Override
    public final List<Field<?>> answer() {
        return List.of(INSIDE);
    }

    @Override
    public final String answers() {
        return """
            {"inside":[true,...]}""";
    }

    @Override
    public final void write(ShapeAndPoints input, Membership inside, ValueSink out)
            throws IOException {
        out.name(INSIDE.name());
        out.startArray();
        for (int i = 0; i < inside.size(); i++) out.flag(inside.inside(i));
        out.endArray();
    }

    /** The method's judgement of all points; with steps, that of its walks. */
    @Override
    protected final Written answered(Call<C> call, ShapeAndPoints input) {
        if (call.steps()) return walked(call, input);
        Membership inside = judged(input, judge(call.method(), input));
        return answer(input, inside, null, null);
    }

    /** A judge that asks the method. */
    protected abstract Membership.PointClassifier judge(C method, ShapeAndPoints input);

    /** Answers by the walks of the method, and their steps. */
    protected abstract Written walked(Call<C> call, ShapeAndPoints input);

    /** Writes the answer of a judge that records steps. */
    protected final Written walked(
            ShapeAndPoints input, Membership.PointClassifier judge, RecordedSteps steps) {
        return answer(input, judged(input, judge), null, steps);
    }

    private static Membership judged(ShapeAndPoints input, Membership.PointClassifier judge) {
        return new Membership(input.points(), input.points().size(), judge);
    }
}
