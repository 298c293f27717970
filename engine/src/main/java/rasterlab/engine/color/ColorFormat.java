package rasterlab.engine.color;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Colours from outside: one in any of the models; the same in all of them out. */
final class ColorFormat extends Format<ColorConverter, Colors, ColorSheet> {
    private static final List<ColorModel> MODELS = List.of(ColorModel.values());
    private static final List<Field<double[]>> COLORS =
            MODELS.stream().map(each -> Field.optional(each.code(), new ColorShape(each))).toList();
    private static final Field<?> LEVELS =
            Field.required("levels", Shape.list("levels", Shape.whole(0, 255), 3, 3));

    ColorFormat(Topic<ColorConverter, Colors, ColorSheet> topic) {
        super(topic);
    }

    /** A colour in a model; a hue may be null, which becomes NaN. */
    private record ColorShape(ColorModel model) implements Shape<double[]> {
        @Override
        public double[] read(ValueSource in) throws IOException {
            var components = new Components(model, new ArrayList<>());
            in.list("numbers", components, model.size(), model.size());
            return components.read.stream().mapToDouble(Double::doubleValue).toArray();
        }

        @Override
        public void write(double[] components, ValueSink out) throws IOException {
            out.numbers(components);
        }

        @Override
        public void schema(ValueSink out) throws IOException {
            out.startObject();
            out.text("type", "array");
            out.name("prefixItems");
            out.startArray();
            for (int i = 0; i < model.size(); i++) component(model, i).schema(out);
            out.endArray();
            out.whole("minItems", model.size());
            out.whole("maxItems", model.size());
            out.endObject();
        }

        static Shape<Double> component(ColorModel model, int index) {
            Shape<Double> share = Shape.number(0, model.highest(index));
            return model.isHue(index) ? EitherShape.orNull(share) : share;
        }
    }

    /** The components one after another, each in its own range. */
    private record Components(ColorModel model, List<Double> read) implements Shape<Double> {
        @Override
        public Double read(ValueSource in) throws IOException {
            Double component = ColorShape.component(model, read.size()).read(in);
            read.add(component == null ? Double.NaN : component);
            return component;
        }

        @Override
        public void write(Double component, ValueSink out) throws IOException {
            out.number(component);
        }

        @Override
        public void schema(ValueSink out) throws IOException {
            new ColorShape(model).schema(out);
        }
    }

    @Override
    public List<Field<?>> input() {
        return List.copyOf(COLORS);
    }

    @Override
    protected List<List<Field<?>>> groups() {
        return COLORS.stream().<List<Field<?>>>map(List::of).toList();
    }

    @Override
    public List<Field<?>> answer() {
        var fields = new ArrayList<Field<?>>();
        for (ColorModel model : MODELS)
            fields.add(
                    Field.required(
                            model.code(),
                            Shape.list(
                                    "numbers",
                                    EitherShape.orNull(Shape.number()),
                                    model.size(),
                                    model.size())));
        fields.add(LEVELS);
        return fields;
    }

    @Override
    public boolean hasSteps() {
        return false;
    }

    @Override
    public String reads() {
        return """
            {"rgb":[r,g,b]}, or "cmy":[c,m,y], "cmyk":[c,m,y,k], "hsv":[h,s,v] or \
            "hvs":[h,v,s]: shares from 0 to 1, hues in degrees, null for a grey""";
    }

    @Override
    public String answers() {
        return """
            {"rgb":[r,g,b], "cmy":[...], "cmyk":[...], "hsv":[...], "hvs":[...], \
            "levels":[r,g,b]}, levels from 0 to 255""";
    }

    @Override
    public Colors read(Given given) {
        List<ColorModel> models = MODELS.stream().filter(each -> given.has(each.code())).toList();
        if (models.size() != 1)
            throw new InvalidInput(
                    "/",
                    "expected one of "
                            + MODELS.stream()
                                    .map(ColorModel::code)
                                    .collect(Collectors.joining(", "))
                            + ", got "
                            + (models.isEmpty() ? "none" : models.size() + " of them"));
        ColorModel model = models.get(0);
        return Colors.of(model, given.get(COLORS.get(MODELS.indexOf(model))));
    }

    @Override
    protected Given given(Colors color) {
        if (color.count() > 1)
            throw new IllegalArgumentException(
                    "one colour is told at a time, got " + color.count());
        ColorModel model = color.model();
        return new Given().with(COLORS.get(MODELS.indexOf(model)), color.components());
    }

    /** {@inheritDoc} One for each colour. */
    @Override
    public List<Colors> singles(Colors colors) {
        return IntStream.range(0, colors.count())
                .mapToObj(i -> Colors.of(colors.model(), colors.color(i)))
                .toList();
    }

    @Override
    public void write(Colors input, ColorSheet sheet, ValueSink out) throws IOException {
        for (ColorModel model : MODELS) out.numbers(model.code(), sheet.in(model));
        out.name(LEVELS.name());
        out.startArray();
        for (double share : sheet.in(ColorModel.RGB)) out.whole(Levels.of(share));
        out.endArray();
    }
}
