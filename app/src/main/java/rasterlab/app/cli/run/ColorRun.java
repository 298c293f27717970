package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorSheet;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.color.Colors;
import rasterlab.engine.color.Levels;
import rasterlab.engine.study.Topic;

/** Topic {@code color}: a colour in one model; in all of them, and its {@code levels}, out. */
final class ColorRun implements TopicRun {
    private static final Map<ColorModel, JsonField<double[]>> MODELS = models();

    private final Topic<ColorConverter, Colors, ColorSheet> topic = new ColorTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ColorRun(Watch watch) {
        this.watch = watch;
    }

    private static Map<ColorModel, JsonField<double[]>> models() {
        var models = new EnumMap<ColorModel, JsonField<double[]>>(ColorModel.class);
        for (ColorModel model : ColorModel.values())
            models.put(model, JsonField.optional(model.code(), json -> colour(json, model)));
        return models;
    }

    private static double[] colour(StrictJson json, ColorModel model) throws IOException {
        var colour = new ArrayList<Double>();
        json.list(
                "numbers",
                each -> colour.add(component(each, model, colour.size())),
                model.size(),
                model.size());
        return colour.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static double component(StrictJson json, ColorModel model, int index)
            throws IOException {
        boolean hue = model.isHue(index);
        return hue && json.isNull() ? Double.NaN : json.numberFrom(0, model.highest(index));
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"rgb":[r,g,b]}, or "cmy":[c,m,y], "cmyk":[c,m,y,k], "hsv":[h,s,v] or \
                "hvs":[h,v,s]: shares from 0 to 1, hues in degrees, null for a grey""",
                """
                {"rgb":[r,g,b], "cmy":[...], "cmyk":[...], "hsv":[...], "hvs":[...], \
                "levels":[r,g,b]}, levels from 0 to 255""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        if (steps) throw Steps.none(method);
        Colors colors = colors(StrictJson.object(text, length, fields()));
        ColorConverter converter = topic.method(method).implementation();
        ColorSheet sheet = watch.call(method, () -> topic.record(converter, colors, 1));
        return json -> write(json, sheet);
    }

    private static JsonField<?>[] fields() {
        return MODELS.values().toArray(JsonField<?>[]::new);
    }

    private static Colors colors(Given given) {
        List<ColorModel> models =
                MODELS.keySet().stream().filter(model -> given.has(model.code())).toList();
        if (models.size() != 1)
            throw Complaint.badInput(
                    "/: expected one of "
                            + MODELS.keySet().stream()
                                    .map(ColorModel::code)
                                    .collect(Collectors.joining(", "))
                            + ", got "
                            + (models.isEmpty() ? "none" : models.size() + " of them"));
        ColorModel model = models.get(0);
        return Colors.of(model, given.get(MODELS.get(model)));
    }

    private static void write(JsonGenerator json, ColorSheet sheet) throws IOException {
        for (ColorModel model : ColorModel.values()) {
            json.writeFieldName(model.code());
            JsonNumbers.write(json, sheet.in(model));
        }
        json.writeArrayFieldStart("levels");
        for (double share : sheet.in(ColorModel.RGB)) json.writeNumber(Levels.of(share));
        json.writeEndArray();
    }
}
