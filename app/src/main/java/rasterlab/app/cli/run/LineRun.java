package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
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
        var decisions = new Doubles();
        while (walk.advance()) if (sink.keep(walk.x(), walk.y())) decisions.add(walk.decision());
        return json -> {
            writePixels(json, sink.kept());
            json.writeStringField("decision", steppedLine.decisionFormula());
            writeSteps(json, sink.kept(), decisions);
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

    private static void writeSteps(JsonGenerator json, PixelRecording pixels, Doubles decisions)
            throws IOException {
        json.writeArrayFieldStart("steps");
        for (int i = 0; i < decisions.size(); i++) {
            json.writeStartObject();
            json.writeNumberField("x", pixels.x(i));
            json.writeNumberField("y", pixels.y(i));
            JsonNumbers.writeField(json, "decision", decisions.get(i));
            json.writeEndObject();
        }
        json.writeEndArray();
    }
}
