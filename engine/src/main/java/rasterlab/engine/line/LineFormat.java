package rasterlab.engine.line;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import rasterlab.contract.CoveragePixels;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.GrowingDoubles;
import rasterlab.engine.format.MadeShape;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.raster.AnsweredPixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Lines from outside: {@code from}, {@code to}, optional {@code window}; {@code pixels} out. */
final class LineFormat extends Format<LineRasterizer, Segment, PixelRecording> {
    /** The most steps of a method that cannot begin at the window: some seconds. */
    private static final int MOST_STEPS = 500_000_000;

    private static final Field<int[]> FROM =
            Field.required("from", Shape.wholes(2)).as(FieldKind.START).in("pixels");
    private static final Field<int[]> TO =
            Field.required("to", Shape.wholes(2)).as(FieldKind.END).in("pixels");
    private static final Field<PixelWindow> WINDOW =
            Field.optional("window", new Window()).as(FieldKind.WINDOW).in("pixels");
    private static final Field<?> COVERAGE =
            Field.optional("coverage", Shape.list(Shape.whole(0, 255)));
    private static final AnsweredPixels.FigureName FIGURE =
            new AnsweredPixels.FigureName("segment", "give a smaller \"window\"");

    LineFormat(Topic<LineRasterizer, Segment, PixelRecording> topic) {
        super(topic);
    }

    /** A window by its sides. */
    private static final class Window extends MadeShape<int[], PixelWindow> {
        Window() {
            super(Shape.wholes(4));
        }

        @Override
        protected PixelWindow made(int[] sides) {
            return new PixelWindow(sides[0], sides[1], sides[2], sides[3]);
        }

        @Override
        protected int[] value(PixelWindow w) {
            return new int[] {w.xmin(), w.ymin(), w.xmax(), w.ymax()};
        }
    }

    @Override
    public List<Field<?>> input() {
        return List.of(FROM, TO, WINDOW);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(AnsweredPixels.FIELD, COVERAGE);
    }

    @Override
    public String reads() {
        return """
            {"from":[x,y], "to":[x,y], "window":[xmin,ymin,xmax,ymax]}, the window being \
            optional; a segment of more than 500000000 steps only for a method that \
            begins at the window""";
    }

    @Override
    public String answers() {
        return """
            {"pixels":[[x,y],...]} in drawing order, and for wu \
            {"coverage":[1..255,...]} beside it""";
    }

    @Override
    public Segment read(Given given) {
        int[] from = given.get(FROM);
        int[] to = given.get(TO);
        PixelWindow window = given.get(WINDOW, PixelWindow.EVERYTHING);
        return new Segment(from[0], from[1], to[0], to[1], window);
    }

    @Override
    protected Given given(Segment s) {
        Given ends =
                new Given()
                        .with(FROM, new int[] {s.x0(), s.y0()})
                        .with(TO, new int[] {s.x1(), s.y1()});
        return s.isWhole() ? ends : ends.with(WINDOW, s.window());
    }

    @Override
    public void write(Segment input, PixelRecording output, ValueSink out) throws IOException {
        AnsweredPixels.write(output, out);
    }

    @Override
    protected void check(Call<LineRasterizer> call, Segment segment) {
        if (!(call.method() instanceof WindowedLine))
            RecordedSteps.requireAtMost(
                    "/to", MOST_STEPS, "steps by " + call.name(), segment.steps());
    }

    @Override
    protected Written answered(Call<LineRasterizer> call, Segment s) {
        AnsweredPixels pixels = pixels(call, s);
        ByteArrayOutputStream coverage = null;
        if (call.method() instanceof CoverageLine shaded) {
            coverage = new ByteArrayOutputStream();
            shaded.shade(s.x0(), s.y0(), s.x1(), s.y1(), new Coverage(pixels, coverage));
        } else if (call.method() instanceof WindowedLine windowed) {
            LineWalk walk = windowed.walk(s.x0(), s.y0(), s.x1(), s.y1(), s.window());
            while (walk.advance()) pixels.plot(walk.x(), walk.y());
        } else {
            call.method().draw(s.x0(), s.y0(), s.x1(), s.y1(), pixels);
        }
        Written steps = call.steps() ? steps(call, s) : null;
        return answer(s, pixels.kept(), coverage == null ? null : levels(coverage), steps);
    }

    private AnsweredPixels pixels(Call<LineRasterizer> call, Segment s) {
        long most = topic().mostBeforeEndless(s.steps() + 1);
        return new AnsweredPixels(call.name(), FIGURE, s.window(), most);
    }

    /** The coverage of each pixel that is kept. */
    private record Coverage(AnsweredPixels pixels, ByteArrayOutputStream levels)
            implements CoveragePixels {
        @Override
        public void plot(int x, int y, int coverage) {
            if (pixels.keep(x, y)) levels.write(coverage);
        }
    }

    private static Written levels(ByteArrayOutputStream coverage) {
        return out -> {
            out.name(COVERAGE.name());
            out.startArray();
            for (byte level : coverage.toByteArray()) out.whole(level & 0xFF);
            out.endArray();
        };
    }

    @Override
    protected Written steps(Call<LineRasterizer> call, Segment s) {
        SteppedLine stepped = call.stepped(SteppedLine.class);
        LineWalk walk =
                stepped instanceof WindowedLine windowed
                        ? windowed.walk(s.x0(), s.y0(), s.x1(), s.y1(), s.window())
                        : stepped.walk(s.x0(), s.y0(), s.x1(), s.y1());
        AnsweredPixels pixels = pixels(call, s);
        var values = new GrowingDoubles();
        while (walk.advance()) if (pixels.keep(walk.x(), walk.y())) values.add(walk.decision());
        return new Walked(stepped.decisionFormula(), pixels.kept(), values);
    }

    /** The walk of a line, each step with its decision value; millions of them, so not a list. */
    private record Walked(String decision, PixelRecording pixels, GrowingDoubles values)
            implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.text("decision", decision);
            out.name("steps");
            out.startArray();
            for (int i = 0; i < values.size(); i++) {
                out.startObject();
                out.whole("x", pixels.x(i));
                out.whole("y", pixels.y(i));
                out.number("decision", values.get(i));
                out.endObject();
            }
            out.endArray();
        }
    }
}
