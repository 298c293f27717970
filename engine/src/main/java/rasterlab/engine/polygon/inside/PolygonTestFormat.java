package rasterlab.engine.polygon.inside;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.PointInPolygon;
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

/** Points in a polygon from outside: {@code polygon}, {@code points}; {@code inside} out. */
public final class PolygonTestFormat extends MembershipFormat<PointInPolygon> {
    /** The most edges looked at whose steps are written. */
    private static final int MOST_STEPS = 1_000_000;

    /** The most edges that all points are compared with: some seconds. */
    private static final int MOST_WORK = 250_000_000;

    private static final String WORK = "corners times points";
    private static final Field<double[]> POLYGON =
            Field.required("polygon", Shape.points(2, 3, Shape.MOST_POINTS)).as(FieldKind.POLYGON);

    public PolygonTestFormat(Topic<PointInPolygon, ShapeAndPoints, Membership> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(POLYGON, POINTS);
    }

    @Override
    public String reads() {
        return """
            {"polygon":[[x,y],...], "points":[[x,y],...]}, corners times points at most 250000000""";
    }

    @Override
    public ShapeAndPoints read(Given given) {
        return new ShapeAndPoints(Points.of(given.get(POLYGON)), Points.of(given.get(POINTS)));
    }

    @Override
    protected Given given(ShapeAndPoints input) {
        return new Given()
                .with(POLYGON, input.corners().numbers())
                .with(POINTS, input.points().numbers());
    }

    @Override
    protected void check(Call<PointInPolygon> call, ShapeAndPoints input) {
        long work = (long) input.corners().size() * input.points().size();
        RecordedSteps.requireAtMost("/points", MOST_WORK, WORK, work);
        if (!call.steps()) return;
        call.stepped(SteppedPolygonTest.class);
        RecordedSteps.requireAtMost(MOST_STEPS, WORK, work);
    }

    @Override
    protected Membership.PointClassifier judge(PointInPolygon method, ShapeAndPoints input) {
        double[] polygonX = input.corners().xs();
        double[] polygonY = input.corners().ys();
        return (x, y) -> method.contains(polygonX, polygonY, x, y);
    }

    /** An edge looked at, with the count after it. */
    private record Step(int edge, int count) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("edge", edge);
            out.whole("count", count);
            out.whole("decision", count);
        }
    }

    @Override
    protected Written walked(Call<PointInPolygon> call, ShapeAndPoints input) {
        SteppedPolygonTest stepped = call.stepped(SteppedPolygonTest.class);
        double[] polygonX = input.corners().xs();
        double[] polygonY = input.corners().ys();
        var steps = new ArrayList<List<Step>>();
        return walked(
                input,
                (x, y) -> {
                    EdgeWalk walk = stepped.walk(polygonX, polygonY, x, y);
                    steps.add(drained(walk));
                    return walk.inside();
                },
                RecordedSteps.decidingLists(stepped.countFormula(), steps));
    }

    private static List<Step> drained(EdgeWalk walk) {
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.edge(), walk.count()));
        return steps;
    }
}
