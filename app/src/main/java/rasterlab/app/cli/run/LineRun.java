package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import rasterlab.app.cli.run.json.Doubles;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
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
    private static final JsonField<int[]> FROM =
            JsonField.required("from", json -> json.integers(2));
    private static final JsonField<int[]> TO = JsonField.required("to", json -> json.integers(2));
    private static final JsonField<int[]> WINDOW =
            JsonField.optional("window", json -> json.integers(4));

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
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Input input = input(text, length);
        LineRasterizer line = topic.method(method).implementation();
        return watch.call(method, () -> draw(method, line, input, steps));
    }

    private record Input(Segment segment, PixelWindow window) {}

    private static Input input(byte[] text, int length) {
        Given given = StrictJson.object(text, length, FROM, TO, WINDOW);
        int[] from = given.get(FROM);
        int[] to = given.get(TO);
        PixelWindow window = given.find(WINDOW).map(LineRun::window).orElse(PixelWindow.EVERYTHING);
        return new Input(new Segment(from[0], from[1], to[0], to[1]), window);
    }

    private static PixelWindow window(int[] given) {
        try {
            return new PixelWindow(given[0], given[1], given[2], given[3]);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput("/window: " + e.getMessage());
        }
    }

    private static Answer draw(String method, LineRasterizer line, Input input, boolean steps) {
        Segment s = input.segment();
        var sink = new LineSink(method, input.window(), s.steps() + 1);
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
        Steps walked = steps ? Steps.of(method, line, input) : null;
        Coverages levels = coverages;
        return json -> {
            writePixels(json, sink.kept());
            if (levels != null) levels.write(json);
            if (walked != null) walked.write(json);
        };
    }

    /** The coverage of each pixel that the sink keeps. */
    private record Coverages(LineSink sink, ByteArrayOutputStream levels)
            implements CoveragePixels {
        Coverages(LineSink sink) {
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

    /** The walk of a line, each step with its decision value. */
    private record Steps(String decision, PixelRecording pixels, Doubles values) {
        static Steps of(String method, LineRasterizer line, Input input) {
            Segment s = input.segment();
            if (!(line instanceof SteppedLine stepped))
                throw Complaint.badInput("--steps: method '" + method + "' has no steps");
            LineWalk walk =
                    line instanceof WindowedLine windowed
                            ? windowed.walk(s.x0(), s.y0(), s.x1(), s.y1(), input.window())
                            : stepped.walk(s.x0(), s.y0(), s.x1(), s.y1());
            var sink = new LineSink(method, input.window(), s.steps() + 1);
            var values = new Doubles();
            while (walk.advance()) if (sink.keep(walk.x(), walk.y())) values.add(walk.decision());
            return new Steps(stepped.decisionFormula(), sink.kept(), values);
        }

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

    private static void writePixels(JsonGenerator json, PixelRecording pixels) throws IOException {
        json.writeArrayFieldStart("pixels");
        for (int i = 0; i < pixels.size(); i++) {
            json.writeStartArray();
            json.writeNumber(pixels.x(i));
            json.writeNumber(pixels.y(i));
            json.writeEndArray();
        }
        json.writeEndArray();
    }
}
