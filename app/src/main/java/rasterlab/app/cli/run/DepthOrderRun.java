package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.OrderStep;
import rasterlab.engine.visibility.order.OrderWalk;
import rasterlab.engine.visibility.order.Painting;
import rasterlab.engine.visibility.order.Sight;
import rasterlab.engine.visibility.order.SteppedOrder;

/**
 * Topic {@code depth-order}: {@code polygons} and {@code eye}; {@code order} back to front and
 * {@code splits} out.
 *
 * <p>Of n polygons, a number below n in the order is a whole one, and n + i is the i-th of the
 * pieces in {@code splits}.
 */
final class DepthOrderRun implements TopicRun {
    private static final int MOST_CORNERS = 1_000_000;
    private static final JsonField<List<double[]>> POLYGONS =
            JsonField.required(
                    "polygons",
                    json ->
                            json.list(
                                    "polygons",
                                    each -> each.points(3, 3, MOST_CORNERS),
                                    0,
                                    PointJson.MOST));
    private static final JsonField<double[]> EYE =
            JsonField.required("eye", json -> json.numbers(3, 3));

    private final DepthOrderTopic topic = new DepthOrderTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    DepthOrderRun(Watch watch) {
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
                {"polygons":[[[x,y,z],...],...], flat and convex, "eye":[x,y,z]}""",
                """
                {"order":[k,...] back to front, of n polygons below n a whole one and n + i \
                splits[i], "splits":[{"polygon":k, "corners":[[x,y,z],...]},...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POLYGONS, EYE);
        var sight = new Sight(given.get(POLYGONS).toArray(double[][]::new), given.get(EYE));
        DepthOrder order = topic.method(method).implementation();
        if (steps) return stepped(method, order, sight);
        Painting painting = watch.call(method, () -> topic.record(order, sight, Integer.MAX_VALUE));
        return json -> write(json, sight, painting);
    }

    private static void write(JsonGenerator json, Sight sight, Painting painting)
            throws IOException {
        double[][] given = sight.polygons();
        var splits = new ArrayList<Painting.Piece>();
        json.writeArrayFieldStart("order");
        for (Painting.Piece piece : painting.pieces())
            if (piece.whole(given[piece.polygon()])) json.writeNumber(piece.polygon());
            else {
                json.writeNumber(given.length + splits.size());
                splits.add(piece);
            }
        json.writeEndArray();
        json.writeArrayFieldStart("splits");
        for (Painting.Piece piece : splits) {
            json.writeStartObject();
            json.writeNumberField("polygon", piece.polygon());
            json.writeFieldName("corners");
            JsonNumbers.writePoints(json, piece.corners(), 3);
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private Answer stepped(String method, DepthOrder order, Sight sight) {
        SteppedOrder stepped = Steps.of(method, order, SteppedOrder.class);
        var painting = new Painting();
        List<OrderStep> all = watch.call(method, () -> drained(stepped.walk(sight, painting::add)));
        return json -> {
            write(json, sight, painting);
            Steps.write(json, stepped.decision(), all, DepthOrderRun::write);
        };
    }

    private static List<OrderStep> drained(OrderWalk walk) {
        var all = new ArrayList<OrderStep>();
        while (walk.advance()) all.add(walk.step());
        return all;
    }

    private static void write(JsonGenerator json, OrderStep step) throws IOException {
        json.writeNumberField(step.kind().name().toLowerCase(Locale.ROOT), step.polygon());
        if (step.kind() == OrderStep.Kind.MOVE) json.writeNumberField("before", step.against());
        if (step.kind() == OrderStep.Kind.CUT) json.writeNumberField("by", step.against());
        JsonNumbers.writeField(json, "decision", step.value());
    }
}
