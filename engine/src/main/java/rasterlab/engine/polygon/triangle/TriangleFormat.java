package rasterlab.engine.polygon.triangle;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.MembershipFormat;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Topic;

/** Points in a triangle from outside: {@code triangle}, {@code points}; {@code inside} out. */
public final class TriangleFormat extends MembershipFormat<PointInTriangle> {
    /** The most points whose steps one answer has. */
    private static final int MOST_STEPPED = 100_000;

    private static final Field<double[]> TRIANGLE =
            Field.required("triangle", Shape.points(2, 3, 3)).as(FieldKind.POLYGON);

    public TriangleFormat(Topic<PointInTriangle, ShapeAndPoints, Membership> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(TRIANGLE, POINTS);
    }

    @Override
    public String reads() {
        return """
            {"triangle":[[x,y],[x,y],[x,y]], "points":[[x,y],...]}""";
    }

    @Override
    public ShapeAndPoints read(Given given) {
        return new ShapeAndPoints(Points.of(given.get(TRIANGLE)), Points.of(given.get(POINTS)));
    }

    @Override
    protected Given given(ShapeAndPoints input) {
        return new Given()
                .with(TRIANGLE, input.corners().numbers())
                .with(POINTS, input.points().numbers());
    }

    @Override
    protected void check(Call<PointInTriangle> call, ShapeAndPoints input) {
        if (!call.steps()) return;
        call.stepped(SteppedTriangleTest.class);
        RecordedSteps.requireAtMost(MOST_STEPPED, "points", input.points().size());
    }

    @Override
    protected Membership.PointClassifier judge(PointInTriangle method, ShapeAndPoints input) {
        Points t = input.corners();
        double ax = t.x(0);
        double ay = t.y(0);
        double bx = t.x(1);
        double by = t.y(1);
        double cx = t.x(2);
        double cy = t.y(2);
        return (x, y) -> method.contains(ax, ay, bx, by, cx, cy, x, y);
    }

    /** A side asked, with what it said. */
    private record Step(int side, double decision) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("side", side);
            out.number("decision", decision);
        }
    }

    @Override
    protected Written walked(Call<PointInTriangle> call, ShapeAndPoints input) {
        SteppedTriangleTest stepped = call.stepped(SteppedTriangleTest.class);
        Points t = input.corners();
        var steps = new ArrayList<List<Step>>();
        return walked(
                input,
                (x, y) -> {
                    SideWalk walk =
                            stepped.walk(t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2), x, y);
                    steps.add(drained(walk));
                    return walk.inside();
                },
                RecordedSteps.decidingLists(stepped.valueFormula(), steps));
    }

    private static List<Step> drained(SideWalk walk) {
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.side(), walk.value()));
        return steps;
    }
}
