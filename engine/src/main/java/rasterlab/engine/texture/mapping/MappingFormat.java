package rasterlab.engine.texture.mapping;

import java.io.IOException;
import java.util.List;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;

/**
 * Textured rows from outside: {@code from}, {@code to}, {@code pixels}; {@code coordinates} out.
 */
final class MappingFormat extends Format<TextureMapper, TexturedSpan, Images> {
    private static final Field<double[]> FROM = end("from");
    private static final Field<double[]> TO = end("to");
    private static final Field<Integer> PIXELS =
            Field.required("pixels", Shape.whole(1, TexturedSpan.MOST_PIXELS));
    private static final Field<?> COORDINATES =
            Field.required("coordinates", Shape.list(Shape.numbersOrNull(2, 2)));

    private static Field<double[]> end(String name) {
        Shape<Double> texture = Shape.number(-TexturedSpan.LARGEST, TexturedSpan.LARGEST);
        Shape<Double> depth = Shape.number(TexturedSpan.NEAREST, TexturedSpan.FARTHEST);
        return Field.required(
                name, Shape.describedByPlace(Shape.numbers(3, 3), texture, texture, depth));
    }

    MappingFormat(Topic<TextureMapper, TexturedSpan, Images> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(FROM, TO, PIXELS);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(COORDINATES);
    }

    @Override
    public boolean hasSteps() {
        return false;
    }

    @Override
    public String reads() {
        return """
            {"from":[s,t,depth], "to":[s,t,depth], "pixels":n}, from and to being the \
            centres of the row's first and last pixel""";
    }

    @Override
    public String answers() {
        return """
            {"coordinates":[[s,t],...]}""";
    }

    @Override
    public TexturedSpan read(Given given) {
        double[] from = given.get(FROM);
        double[] to = given.get(TO);
        try {
            return new TexturedSpan(
                    from[0], from[1], from[2], to[0], to[1], to[2], given.get(PIXELS));
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(TexturedSpan span) {
        return new Given()
                .with(FROM, new double[] {span.fromS(), span.fromT(), span.fromDepth()})
                .with(TO, new double[] {span.toS(), span.toT(), span.toDepth()})
                .with(PIXELS, span.pixels());
    }

    @Override
    public void write(TexturedSpan input, Images st, ValueSink out) throws IOException {
        out.points(COORDINATES.name(), st.coordinates(), 2);
    }
}
