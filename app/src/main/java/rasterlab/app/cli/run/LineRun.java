package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import rasterlab.app.cli.run.json.Doubles;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.CoveragePixels;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.CoverageLine;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.LineWalk;
import rasterlab.engine.line.Segment;
import rasterlab.engine.line.SteppedLine;
import rasterlab.engine.line.WindowedLine;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Topic;

/** Topic {@code line}: {@code from}, {@code to}, optional {@code window}; {@code pixels} out. */
public final class LineRun implements TopicRun {
    /** The most steps of a method that cannot begin at the window: some seconds. */
    private static final int MOST_STEPS = 500_000_000;

    private static final JsonField<int[]> FROM =
            JsonField.required("from", json -> json.integers(2));
    private static final JsonField<int[]> TO = JsonField.required("to", json -> json.integers(2));
    private static final JsonField<PixelWindow> WINDOW =
            JsonField.optional("window", json -> json.checked(LineRun::window));
    private static final PixelSink.Figure FIGURE =
            new PixelSink.Figure("segment", "give a smaller \"window\"");

    private final Topic<LineRasterizer, Segment, PixelRecording> topic = new LineTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    LineRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"from":[x,y], "to":[x,y], "window":[xmin,ymin,xmax,ymax]}, the window being \
                optional; a segment of more than 500000000 steps only for a method that \
                begins at the window""",
                """
                {"pixels":[[x,y],...]} in drawing order, and for wu \
                {"coverage":[1..255,...]} beside it""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Input input = input(text, length);
        LineRasterizer line = topic.method(method).implementation();
        if (!(line instanceof WindowedLine))
            Work.requireAtMost("/to", MOST_STEPS, "steps by " + method, input.segment().steps());
        return watch.call(method, () -> draw(method, line, input, steps));
    }

    private record Input(Segment segment, PixelWindow window) {}

    private static Input input(byte[] text, int length) {
        Given given = StrictJson.object(text, length, FROM, TO, WINDOW);
        int[] from = given.get(FROM);
        int[] to = given.get(TO);
        PixelWindow window = given.find(WINDOW).orElse(PixelWindow.EVERYTHING);
        return new Input(new Segment(from[0], from[1], to[0], to[1]), window);
    }

    private static PixelWindow window(StrictJson json) throws IOException {
        int[] sides = json.integers(4);
        return new PixelWindow(sides[0], sides[1], sides[2], sides[3]);
    }

    private PixelSink sink(String method, Input input) {
        long most = topic.mostBeforeEndless(input.segment().steps() + 1);
        return new PixelSink(method, FIGURE, input.window(), most);
    }

    private Answer draw(String method, LineRasterizer line, Input input, boolean steps) {
        Segment s = input.segment();
        PixelSink sink = sink(method, input);
        Coverages coverages = null;
        if (line instanceof CoverageLine shaded) {
            coverages = new Coverages(sink);
            shaded.shade(s.x0(), s.y0(), s.x1(), s.y1(), coverages);
        } else if (line instanceof WindowedLine windowed) {
            LineWalk walk = windowed.walk(s.x0(), s.y0(), s.x1(), s.y1(), input.window());
            while (walk.advance()) sink.plot(walk.x(), walk.y());
        } else {
            line.draw(s.x0(), s.y0(), s.x1(), s.y1(), sink);
        }
        Walked walked = steps ? walked(method, line, input) : null;
        Coverages levels = coverages;
        return json -> {
            PixelJson.write(json, sink.kept());
            if (levels != null) levels.write(json);
            if (walked != null) walked.write(json);
        };
    }

    /** The coverage of each pixel that the sink keeps. */
    private record Coverages(PixelSink sink, ByteArrayOutputStream levels)
            implements CoveragePixels {
        Coverages(PixelSink sink) {
            this(sink, new ByteArrayOutputStream());
        }

        @Override
        public void plot(int x, int y, int coverage) {
            if (sink.keep(x, y)) levels.write(coverage);
        }

        void write(JsonGenerator json) throws IOException {
            json.writeArrayFieldStart("coverage");
            for (byte level : levels.toByteArray()) json.writeNumber(level & 0xFF);
            json.writeEndArray();
        }
    }

    private Walked walked(String method, LineRasterizer line, Input input) {
        Segment s = input.segment();
        SteppedLine stepped = Steps.of(method, line, SteppedLine.class);
        LineWalk walk =
                line instanceof WindowedLine windowed
                        ? windowed.walk(s.x0(), s.y0(), s.x1(), s.y1(), input.window())
                        : stepped.walk(s.x0(), s.y0(), s.x1(), s.y1());
        PixelSink sink = sink(method, input);
        var values = new Doubles();
        while (walk.advance()) if (sink.keep(walk.x(), walk.y())) values.add(walk.decision());
        return new Walked(stepped.decisionFormula(), sink.kept(), values);
    }

    /** The walk of a line, each step with its decision value; millions of them, so not a list. */
    private record Walked(String decision, PixelRecording pixels, Doubles values) {
        void write(JsonGenerator json) throws IOException {
            json.writeStringField("decision", decision);
            json.writeArrayFieldStart("steps");
            for (int i = 0; i < values.size(); i++) {
                json.writeStartObject();
                json.writeNumberField("x", pixels.x(i));
                json.writeNumberField("y", pixels.y(i));
                JsonNumbers.writeField(json, "decision", values.get(i));
                json.writeEndObject();
            }
            json.writeEndArray();
        }
    }
}
