package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Topic;
import rasterlab.engine.texture.TexelShare;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.filter.FilteredPixels;
import rasterlab.engine.texture.filter.SteppedFilter;

/** Topic {@code texture-filter}: a grey picture and pixels that show it; their levels out. */
final class TextureFilterRun implements TopicRun {
    private static final JsonField<List<List<Integer>>> PICTURE =
            JsonField.required(
                    "picture",
                    json ->
                            json.list(
                                    "rows",
                                    row ->
                                            row.list(
                                                    "levels",
                                                    each -> each.integer(0, 255),
                                                    1,
                                                    Texture.LARGEST),
                                    1,
                                    Texture.LARGEST));
    private static final JsonField<double[]> PIXELS =
            JsonField.required("pixels", json -> json.points(6, 0, PointJson.MOST));

    private static final String SHARE =
            "share of the texel in the colour; detail 0 is the picture, each further one half as"
                    + " large";

    private final Topic<TextureFilter, FilteredPixels, double[]> topic = new FilterTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    TextureFilterRun(Watch watch) {
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
                {"picture":[[level,...],...], "pixels":[[s,t,dsdx,dtdx,dsdy,dtdy],...]}, \
                rows of grey levels from 0 to 255, the top row first; (s,t) = (0,0) is the \
                bottom left corner""",
                """
                {"levels":[level,...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        FilteredPixels pixels = pixels(StrictJson.object(text, length, PICTURE, PIXELS));
        TextureFilter filter = topic.method(method).implementation();
        double[] levels = watch.call(method, () -> topic.record(filter, pixels, Integer.MAX_VALUE));
        List<List<TexelShare>> walk =
                steps
                        ? watch.call(
                                method,
                                () -> Steps.of(method, filter, SteppedFilter.class).texels(pixels))
                        : List.of();
        return json -> {
            json.writeArrayFieldStart("levels");
            for (int i = 1; i < levels.length; i += 4) json.writeNumber((int) levels[i]);
            json.writeEndArray();
            if (steps) Steps.writeLists(json, SHARE, walk, TextureFilterRun::write);
        };
    }

    private static void write(JsonGenerator json, TexelShare texel) throws IOException {
        json.writeNumberField("detail", texel.level());
        json.writeNumberField("column", texel.i());
        json.writeNumberField("row-from-below", texel.j());
        json.writeNumberField("level", texel.argb() & 255);
        JsonNumbers.writeField(json, "decision", texel.share());
    }

    private static FilteredPixels pixels(Given given) {
        List<List<Integer>> rows = given.get(PICTURE);
        int width = rows.get(0).size();
        int height = rows.size();
        var argb = new int[width * height];
        for (int y = 0; y < height; y++) {
            List<Integer> row = rows.get(y);
            if (row.size() != width)
                throw given.complaint(
                        "picture/" + y, row.size() + " levels; expected " + width + " as in row 0");
            for (int x = 0; x < width; x++)
                argb[(height - 1 - y) * width + x] = 0xFF000000 | 0x010101 * row.get(x);
        }
        try {
            return new FilteredPixels(width, height, argb, given.get(PIXELS));
        } catch (IllegalArgumentException e) {
            throw EngineRefusal.complaint(e);
        }
    }
}
