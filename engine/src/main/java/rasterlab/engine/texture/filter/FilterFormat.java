package rasterlab.engine.texture.filter;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.texture.TexelShare;
import rasterlab.engine.texture.Texture;

/** Filtered pixels from outside: {@code picture}, {@code pixels}; {@code levels} out. */
final class FilterFormat extends Format<TextureFilter, FilteredPixels, double[]> {
    private static final Shape<Integer> LEVEL = Shape.whole(0, 255);
    private static final Field<List<List<Integer>>> PICTURE =
            Field.required(
                    "picture",
                    Shape.list(
                            "rows",
                            Shape.list("levels", LEVEL, 1, Texture.LARGEST),
                            1,
                            Texture.LARGEST));
    private static final Field<double[]> PIXELS =
            Field.required("pixels", Shape.points(6, 0, Shape.MOST_POINTS));
    private static final Field<?> LEVELS = Field.required("levels", Shape.list(LEVEL));

    private static final String SHARE =
            "share of the texel in the colour; detail 0 is the picture, each further one half as"
                    + " large";

    FilterFormat(Topic<TextureFilter, FilteredPixels, double[]> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(PICTURE, PIXELS);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(LEVELS);
    }

    @Override
    public String reads() {
        return """
            {"picture":[[level,...],...], "pixels":[[s,t,dsdx,dtdx,dsdy,dtdy],...]}, \
            rows of grey levels from 0 to 255, the top row first; (s,t) = (0,0) is the \
            bottom left corner""";
    }

    @Override
    public String answers() {
        return """
            {"levels":[level,...]}""";
    }

    @Override
    public FilteredPixels read(Given given) {
        List<List<Integer>> rows = given.get(PICTURE);
        int width = rows.get(0).size();
        int height = rows.size();
        var argb = new int[width * height];
        for (int y = 0; y < height; y++) {
            List<Integer> row = rows.get(y);
            if (row.size() != width)
                throw given.invalid(
                        "picture/" + y,
                        "expected %d levels as /picture/0 has, got %d"
                                .formatted(width, row.size()));
            for (int x = 0; x < width; x++)
                argb[(height - 1 - y) * width + x] = 0xFF000000 | 0x010101 * row.get(x);
        }
        try {
            return new FilteredPixels(width, height, argb, given.get(PIXELS));
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(FilteredPixels pixels) {
        var rows = new ArrayList<List<Integer>>();
        for (int y = 0; y < pixels.height(); y++) {
            int below = (pixels.height() - 1 - y) * pixels.width();
            rows.add(
                    Arrays.stream(pixels.argb(), below, below + pixels.width())
                            .map(FilterFormat::gray)
                            .boxed()
                            .toList());
        }
        return new Given().with(PICTURE, rows).with(PIXELS, pixels.footprints());
    }

    private static int gray(int argb) {
        int level = argb & 0xFF;
        if (argb != (0xFF000000 | 0x010101 * level))
            throw new IllegalArgumentException(
                    "a picture is told in greys, got " + Integer.toHexString(argb));
        return level;
    }

    @Override
    public void write(FilteredPixels input, double[] levels, ValueSink out) throws IOException {
        out.name(LEVELS.name());
        out.startArray();
        for (int i = 1; i < levels.length; i += 4) out.whole((int) levels[i]);
        out.endArray();
    }

    /** A texel with its share. */
    private record Step(TexelShare texel) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("detail", texel.level());
            out.whole("column", texel.i());
            out.whole("row-from-below", texel.j());
            out.whole("level", texel.argb() & 255);
            out.number("decision", texel.share());
        }
    }

    @Override
    protected Written steps(Call<TextureFilter> call, FilteredPixels pixels) {
        return RecordedSteps.decidingLists(
                SHARE,
                call.stepped(SteppedFilter.class).texels(pixels).stream()
                        .map(texels -> texels.stream().map(Step::new).toList())
                        .toList());
    }
}
