package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.DepthFormat;
import rasterlab.contract.DepthRange;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.depth.DepthBufferTopic;
import rasterlab.engine.visibility.depth.DepthCell;
import rasterlab.engine.visibility.depth.DepthRows;
import rasterlab.engine.visibility.depth.DepthWalk;
import rasterlab.engine.visibility.depth.SteppedDepth;
import rasterlab.engine.visibility.depth.StoredDepths;

/**
 * Topic {@code depth-buffer}: {@code near}, {@code far}, {@code depths}, {@code to}, {@code
 * pixels}; {@code codes}, {@code stored}, {@code z}, {@code separable}, {@code front} out.
 */
final class DepthBufferRun implements TopicRun {
    private static final JsonField<Double> NEAR = JsonField.required("near", StrictJson::number);
    private static final JsonField<Double> FAR = JsonField.optional("far", StrictJson::number);
    private static final JsonField<double[]> DEPTHS =
            JsonField.required("depths", json -> json.numbers(1, DepthRows.MOST_SURFACES));
    private static final JsonField<double[]> TO =
            JsonField.optional("to", json -> json.numbers(1, DepthRows.MOST_SURFACES));
    private static final JsonField<Integer> PIXELS =
            JsonField.optional("pixels", json -> json.integer(1, DepthRows.MOST_PIXELS));

    private final Topic<DepthFormat, DepthRows, StoredDepths> topic = new DepthBufferTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    DepthBufferRun(Watch watch) {
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
                {"near":z, "far":z, "depths":[z,...], "to":[z,...], "pixels":n}, no far plane \
                without far, one pixel without pixels; depths are those of surfaces in the first \
                pixel of a scan line, to those in the last, as depths without to""",
                """
                {"codes":[...], "stored":[...], "z":[...], "separable":[...], "front":[...]}, \
                surface after surface, pixel after pixel; separable is how far behind a depth is \
                told apart, null where none up to far is; front is the surface left in each pixel""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        DepthRows rows = rows(StrictJson.object(text, length, NEAR, FAR, DEPTHS, TO, PIXELS));
        DepthFormat format = topic.method(method).implementation();
        return watch.call(method, () -> stored(method, format, rows, steps));
    }

    private static DepthRows rows(Given given) {
        double[] depths = given.get(DEPTHS);
        if (given.has(TO.name()) && !given.has(PIXELS.name()))
            throw Complaint.badInput("/pixels: missing, to needs it");
        try {
            double far = given.find(FAR).orElse(Double.POSITIVE_INFINITY);
            return new DepthRows(
                    new DepthRange(given.get(NEAR), far),
                    depths,
                    given.find(TO).orElse(depths),
                    given.find(PIXELS).orElse(1));
        } catch (IllegalArgumentException e) {
            throw EngineRefusal.complaint(e);
        }
    }

    private Answer stored(String method, DepthFormat format, DepthRows rows, boolean steps) {
        List<List<Step>> walked =
                steps ? steps(Steps.of(method, format, SteppedDepth.class), rows) : List.of();
        StoredDepths stored = topic.record(format, rows, Integer.MAX_VALUE);
        double[] behind = DepthCell.behind(format, rows);
        DepthFormat.Codes codes = format.over(rows.range());
        return json -> {
            write(json, "codes", stored.codes());
            write(
                    json,
                    "stored",
                    IntStream.of(stored.codes()).mapToDouble(codes::stored).toArray());
            write(json, "z", stored.depths());
            write(json, "separable", behind);
            write(json, "front", IntStream.range(0, rows.pixels()).map(stored::front).toArray());
            if (format instanceof SteppedDepth stepped && steps)
                Steps.writeLists(
                        json, stepped.decisionFormula(), walked, (out, step) -> step.write(out));
        };
    }

    private static void write(JsonGenerator json, String name, int[] values) throws IOException {
        json.writeFieldName(name);
        json.writeArray(values, 0, values.length);
    }

    private static void write(JsonGenerator json, String name, double[] values) throws IOException {
        json.writeFieldName(name);
        JsonNumbers.write(json, values);
    }

    private record Step(int pixel, double sum, int code, double decision) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("pixel", pixel);
            JsonNumbers.writeField(json, "sum", sum);
            json.writeNumberField("code", code);
            JsonNumbers.writeField(json, "decision", decision);
        }
    }

    private static List<List<Step>> steps(SteppedDepth format, DepthRows rows) {
        var lists = new ArrayList<List<Step>>();
        for (int s = 0; s < rows.surfaces(); s++) {
            var steps = new ArrayList<Step>();
            DepthWalk walk =
                    format.walk(rows.range(), rows.nearness(s), rows.perPixel(s), rows.pixels());
            do steps.add(new Step(walk.pixel(), walk.sum(), walk.code(), walk.decision()));
            while (walk.advance());
            lists.add(steps);
        }
        return lists;
    }
}
