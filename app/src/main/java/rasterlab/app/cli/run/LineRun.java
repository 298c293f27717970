package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.LineWalk;
import rasterlab.engine.line.Segment;
import rasterlab.engine.line.SteppedLine;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Topic;

/** Topic {@code line}: {@code from}, {@code to}, optional {@code window}; {@code pixels} out. */
public final class LineRun implements TopicRun {
    private static final List<String> REQUIRED = List.of("from", "to");
    private static final Map<String, StrictJson.Field<int[]>> FIELDS =
            Map.of(
                    "from", json -> json.integers(2),
                    "to", json -> json.integers(2),
                    "window", json -> json.integers(4));

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
        Map<String, int[]> given = StrictJson.object(text, length, FIELDS, REQUIRED);
        int[] from = given.get("from");
        int[] to = given.get("to");
        return new Input(new Segment(from[0], from[1], to[0], to[1]), window(given.get("window")));
    }

    private static PixelWindow window(int[] given) {
        if (given == null) return PixelWindow.EVERYTHING;
        try {
            return new PixelWindow(given[0], given[1], given[2], given[3]);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput("/window: " + e.getMessage());
        }
    }

    private static Answer draw(String method, LineRasterizer line, Input input, boolean steps) {
        var sink = new LineSink(method, input.window(), input.segment().steps() + 1);
        if (steps) return stepped(method, line, input.segment(), sink);
        Segment s = input.segment();
        line.draw(s.x0(), s.y0(), s.x1(), s.y1(), sink);
        return json -> writePixels(json, sink.kept());
    }

    private static Answer stepped(String method, LineRasterizer line, Segment s, LineSink sink) {
        if (!(line instanceof SteppedLine steppedLine))
            throw Complaint.badInput("--steps: method '" + method + "' has no steps");
        LineWalk walk = steppedLine.walk(s.x0(), s.y0(), s.x1(), s.y1());
        var decisions = new Decisions();
        while (walk.advance()) if (sink.keep(walk.x(), walk.y())) decisions.add(walk.decision());
        return json -> {
            writePixels(json, sink.kept());
            decisions.write(json, steppedLine.decisionFormula(), sink.kept());
        };
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

    /** The decision value of each kept step. */
    private static final class Decisions {
        private double[] values = new double[64];
        private int size;

        void add(double value) {
            if (size == values.length) values = Arrays.copyOf(values, 2 * size);
            values[size++] = value;
        }

        void write(JsonGenerator json, String formula, PixelRecording pixels) throws IOException {
            json.writeStringField("decision", formula);
            json.writeArrayFieldStart("steps");
            for (int i = 0; i < size; i++) {
                json.writeStartObject();
                json.writeNumberField("x", pixels.x(i));
                json.writeNumberField("y", pixels.y(i));
                if (Double.isFinite(values[i])) json.writeNumberField("decision", values[i]);
                else json.writeNullField("decision");
                json.writeEndObject();
            }
            json.writeEndArray();
        }
    }
}
