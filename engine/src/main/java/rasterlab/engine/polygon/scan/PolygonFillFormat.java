package rasterlab.engine.polygon.scan;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.raster.AnsweredPixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Topic;

/**
 * Filled polygons from outside: {@code polygon}, {@code rule}, {@code size}; {@code pixels} out.
 */
final class PolygonFillFormat extends Format<PolygonFiller, PolygonTask, PixelRecording> {
    private static final int MOST_CORNERS = 1_000_000;
    private static final String DECISION = "how many edges cross the row";
    private static final Field<double[]> POLYGON =
            Field.required("polygon", Shape.points(2, 0, MOST_CORNERS))
                    .as(FieldKind.POLYGON)
                    .in("pixels");
    private static final Field<String> RULE =
            Field.required("rule", Shape.word(List.of("evenodd", "nonzero")));
    private static final Field<List<Integer>> SIZE =
            Field.required(
                            "size",
                            Shape.list("whole numbers", Shape.whole(1, Raster.LARGEST_SIDE), 2, 2))
                    .in("pixels");

    PolygonFillFormat(Topic<PolygonFiller, PolygonTask, PixelRecording> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(POLYGON, RULE, SIZE);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(AnsweredPixels.FIELD);
    }

    @Override
    public String reads() {
        return """
            {"polygon":[[x,y],...], "rule":"evenodd" or "nonzero", "size":[w,h]}""";
    }

    @Override
    public String answers() {
        return """
            {"pixels":[[x,y],...]} row by row""";
    }

    @Override
    public PolygonTask read(Given given) {
        Points corners = Points.of(given.get(POLYGON));
        FillRule rule = given.get(RULE).equals("evenodd") ? FillRule.EVEN_ODD : FillRule.NON_ZERO;
        List<Integer> size = given.get(SIZE);
        return new PolygonTask(corners.xs(), corners.ys(), rule, size.get(0), size.get(1));
    }

    @Override
    protected Given given(PolygonTask task) {
        return new Given()
                .with(POLYGON, new Points(task.x(), task.y()).numbers())
                .with(RULE, task.rule() == FillRule.EVEN_ODD ? "evenodd" : "nonzero")
                .with(SIZE, List.of(task.width(), task.height()));
    }

    @Override
    public void write(PolygonTask input, PixelRecording pixels, ValueSink out) throws IOException {
        AnsweredPixels.write(pixels, out);
    }

    /** {@inheritDoc} Too many steps are told before too many pixels. */
    @Override
    protected Written answered(Call<PolygonFiller> call, PolygonTask task) {
        Written steps = call.steps() ? steps(call, task) : null;
        return answer(task, recorded(call, task), null, steps);
    }

    @Override
    protected PixelRecording recorded(Call<PolygonFiller> call, PolygonTask task) {
        try {
            return topic().record(call.method(), task, AnsweredPixels.MOST);
        } catch (LimitReached tooMany) {
            throw AnsweredPixels.tooMany("give a smaller \"size\"");
        }
    }

    private record Step(int y, int from, int to, int crossings) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("y", y);
            out.whole("from", from);
            out.whole("to", to);
            out.whole("decision", crossings);
        }
    }

    @Override
    protected Written steps(Call<PolygonFiller> call, PolygonTask task) {
        var steps = new ArrayList<Step>();
        SpanWalk walk =
                call.stepped(SteppedPolygon.class)
                        .walk(task.x(), task.y(), task.rule(), task.width(), task.height());
        while (walk.advance())
            RecordedSteps.add(steps, new Step(walk.y(), walk.from(), walk.to(), walk.crossings()));
        return RecordedSteps.deciding(DECISION, steps);
    }
}
