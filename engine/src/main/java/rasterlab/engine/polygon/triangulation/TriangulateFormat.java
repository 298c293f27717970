package rasterlab.engine.polygon.triangulation;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.Triangulator;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Triangulated polygons from outside: {@code polygon}; {@code triangles} out. */
final class TriangulateFormat extends Format<Triangulator, Points, Triangles> {
    private static final String VALUE = "; the value is the squared length of the diagonal";
    private static final Field<double[]> POLYGON =
            Field.required("polygon", Shape.points(2, 3, Shape.MOST_POINTS)).as(FieldKind.POLYGON);
    private static final Field<?> TRIANGLES =
            Field.required("triangles", Shape.list(Shape.wholes(3))).as(FieldKind.TRIANGLES);

    TriangulateFormat(Topic<Triangulator, Points, Triangles> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(POLYGON);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(TRIANGLES);
    }

    @Override
    public String reads() {
        return """
            {"polygon":[[x,y],...]}""";
    }

    @Override
    public String answers() {
        return """
            {"triangles":[[i,j,k],...]}, corner numbers from 0, counter-clockwise with y \
            up""";
    }

    @Override
    public Points read(Given given) {
        return Points.of(given.get(POLYGON));
    }

    @Override
    protected Given given(Points polygon) {
        return new Given().with(POLYGON, polygon.numbers());
    }

    @Override
    public void write(Points input, Triangles triangles, ValueSink out) throws IOException {
        out.name(TRIANGLES.name());
        out.startArray();
        for (int i = 0; i < triangles.size(); i++)
            out.wholes(triangles.corner(i, 0), triangles.corner(i, 1), triangles.corner(i, 2));
        out.endArray();
    }

    /**
     * A triangle that is cut off.
     *
     * @param decision squared length of the diagonal a–c
     */
    private record Cut(int a, int b, int c, double decision) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("cut", b);
            out.wholes("diagonal", a, c);
            out.number("decision", decision);
        }
    }

    /** {@inheritDoc} With steps the triangles are those of the walk. */
    @Override
    protected Written answered(Call<Triangulator> call, Points polygon) {
        if (!call.steps()) return super.answered(call, polygon);
        SteppedTriangulator stepped = call.stepped(SteppedTriangulator.class);
        List<Cut> cuts = cuts(stepped, polygon);
        int[] corners = cuts.stream().flatMapToInt(TriangulateFormat::corners).toArray();
        RecordedSteps steps = RecordedSteps.deciding(stepped.choice() + VALUE, cuts);
        return answer(polygon, new Triangles(corners), null, steps);
    }

    private static IntStream corners(Cut cut) {
        return IntStream.of(cut.a, cut.b, cut.c);
    }

    private static List<Cut> cuts(SteppedTriangulator stepped, Points polygon) {
        var cuts = new ArrayList<Cut>();
        TriangleWalk walk = stepped.walk(polygon.xs(), polygon.ys());
        while (walk.advance()) {
            double dx = polygon.x(walk.c()) - polygon.x(walk.a());
            double dy = polygon.y(walk.c()) - polygon.y(walk.a());
            cuts.add(new Cut(walk.a(), walk.b(), walk.c(), dx * dx + dy * dy));
        }
        return cuts;
    }
}
