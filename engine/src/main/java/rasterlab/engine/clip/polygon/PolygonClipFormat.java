package rasterlab.engine.clip.polygon;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.PolygonClipper;
import rasterlab.engine.clip.GivenWindow;
import rasterlab.engine.clip.PartFormat;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Clipped polygons from outside: {@code window}, {@code polygon}; {@code polygons} out. */
final class PolygonClipFormat extends Format<PolygonClipper, PolygonInWindow, List<double[]>> {
    private static final String DECISION = "how many corners the step leaves";
    private static final Field<double[]> POLYGON =
            Field.required("polygon", Shape.points(2, 0, PartFormat.MOST)).as(FieldKind.POLYGON);
    private static final Field<?> POLYGONS =
            Field.required("polygons", Shape.list(Shape.list(Shape.numbersOrNull(2, 2))))
                    .as(FieldKind.POLYGONS);

    PolygonClipFormat(Topic<PolygonClipper, PolygonInWindow, List<double[]>> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(GivenWindow.FIELD, POLYGON);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(POLYGONS);
    }

    @Override
    public String reads() {
        return """
            {"window":[xmin,ymin,xmax,ymax], "polygon":[[x,y],...]}, or for a window the \
            corners of a convex polygon""";
    }

    @Override
    public String answers() {
        return """
            {"polygons":[[[x,y],...],...]}, counter-clockwise""";
    }

    @Override
    public PolygonInWindow read(Given given) {
        GivenWindow window = given.get(GivenWindow.FIELD);
        double[] n = window.numbers();
        double[] corners = window.upright() ? PolygonInWindow.rectangle(n[0], n[1], n[2], n[3]) : n;
        return new PolygonInWindow(corners, given.get(POLYGON));
    }

    @Override
    protected Given given(PolygonInWindow input) {
        return new Given()
                .with(GivenWindow.FIELD, new GivenWindow(false, input.window()))
                .with(POLYGON, input.subject());
    }

    @Override
    public void write(PolygonInWindow input, List<double[]> pieces, ValueSink out)
            throws IOException {
        out.name(POLYGONS.name());
        out.startArray();
        for (double[] piece : pieces) out.points(piece, 2);
        out.endArray();
    }

    /** {@inheritDoc} Steps are told to be too many before anything is clipped. */
    @Override
    protected void check(Call<PolygonClipper> call, PolygonInWindow input) {
        if (!call.steps()) return;
        call.stepped(SteppedPolygonClipper.class);
        RecordedSteps.requireAtMost(PartFormat.MOST_STEPPED, "corners", input.subject().length / 2);
    }

    private record Step(String at, double[] polygon) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("at", at);
            out.whole("decision", polygon.length / 2);
            out.points("polygon", polygon, 2);
        }
    }

    @Override
    protected Written steps(Call<PolygonClipper> call, PolygonInWindow input) {
        var steps = new ArrayList<Step>();
        PolygonWalk walk =
                call.stepped(SteppedPolygonClipper.class).walk(input.window(), input.subject());
        while (walk.advance()) steps.add(new Step(walk.at(), walk.polygon()));
        return RecordedSteps.deciding(DECISION, steps);
    }
}
