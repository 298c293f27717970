package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Topic;
import rasterlab.engine.texture.mapping.MappingTopic;
import rasterlab.engine.transform.Images;

/** Topic {@code texture-mapping}: a row of pixels; {@code coordinates} of each out. */
final class TextureMappingRun implements TopicRun {
    private static final JsonField<double[]> FROM = LightJson.vector("from");
    private static final JsonField<double[]> TO = LightJson.vector("to");
    private static final JsonField<Integer> PIXELS =
            JsonField.required("pixels", json -> json.integer(1, TexturedSpan.MOST_PIXELS));

    private final Topic<TextureMapper, TexturedSpan, Images> topic = new MappingTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    TextureMappingRun(Watch watch) {
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
                {"from":[s,t,depth], "to":[s,t,depth], "pixels":n}, from and to being the \
                centres of the row's first and last pixel""",
                """
                {"coordinates":[[s,t],...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        if (steps) throw Steps.none(method);
        TexturedSpan span = span(StrictJson.object(text, length, FROM, TO, PIXELS));
        TextureMapper mapper = topic.method(method).implementation();
        Images st = watch.call(method, () -> topic.record(mapper, span, Integer.MAX_VALUE));
        return json -> {
            json.writeFieldName("coordinates");
            JsonNumbers.writePoints(json, st.coordinates(), 2);
        };
    }

    private static TexturedSpan span(Given given) {
        double[] from = given.get(FROM);
        double[] to = given.get(TO);
        try {
            return new TexturedSpan(
                    from[0], from[1], from[2], to[0], to[1], to[2], given.get(PIXELS));
        } catch (IllegalArgumentException e) {
            throw EngineRefusal.complaint(e);
        }
    }
}
