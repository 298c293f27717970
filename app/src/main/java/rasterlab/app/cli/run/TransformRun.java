package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.chain.TransformTopic.Output;

/**
 * Topic {@code transform}: {@code matrices}, {@code points}; {@code points} after the division and
 * {@code h} out. A point with h = 0 has no image and is null.
 */
final class TransformRun implements TopicRun {
    /** The most points after each of the matrices in one answer. */
    private static final int MOST_STEPPED = 1_000_000;

    private final Topic<PointTransformer, Chain, Output> topic = new TransformTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    TransformRun(Watch watch) {
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
                {"matrices":[...], "points":[[x,y,z],...]}, each matrix by name as for topic \
                matrix or by its rows; a point may be homogeneous, [x,y,z,h], at infinity with h = 0""",
                """
                {"points":[...], "h":[...]}, null where h is 0""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Chain chain = ChainJson.read(text, length);
        PointTransformer transformer = topic.method(method).implementation();
        if (steps)
            Steps.requireAtMost(
                    MOST_STEPPED,
                    "points times matrices",
                    (long) chain.points().length / chain.dimension() * chain.matrices().length);
        if (steps) return stepped(watch.call(method, () -> stages(transformer, chain)));
        Output output = watch.call(method, () -> run(transformer, chain));
        return json -> write(json, output);
    }

    private Output run(PointTransformer transformer, Chain chain) {
        return topic.record(transformer, chain, Integer.MAX_VALUE);
    }

    /** The points after each matrix of the list. */
    private List<Output> stages(PointTransformer transformer, Chain chain) {
        var stages = new ArrayList<Output>();
        for (int i = 0; i <= chain.matrices().length; i++)
            stages.add(
                    run(
                            transformer,
                            new Chain(
                                    chain.dimension(),
                                    Arrays.copyOf(chain.matrices(), i),
                                    chain.points(),
                                    chain.h())));
        return stages;
    }

    private static Answer stepped(List<Output> stages) {
        return json -> {
            write(json, stages.get(stages.size() - 1));
            json.writeArrayFieldStart("steps");
            for (int i = 0; i < stages.size(); i++) {
                json.writeStartObject();
                json.writeNumberField("matrices", i);
                write(json, stages.get(i));
                json.writeEndObject();
            }
            json.writeEndArray();
        };
    }

    private static void write(JsonGenerator json, Output output) throws IOException {
        int dimension = output.images().dimension();
        double[] all = output.images().coordinates();
        json.writeArrayFieldStart("points");
        for (int i = 0; i < output.h().length; i++)
            if (output.images().has(i))
                JsonNumbers.write(
                        json, Arrays.copyOfRange(all, i * dimension, (i + 1) * dimension));
            else json.writeNull();
        json.writeEndArray();
        json.writeFieldName("h");
        JsonNumbers.write(json, output.h());
    }
}
