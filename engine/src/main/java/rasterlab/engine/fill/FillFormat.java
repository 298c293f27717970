package rasterlab.engine.fill;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Pixels;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.format.AnswerLimitReached;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;
import rasterlab.engine.format.Written;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Filled pictures from outside: {@code picture} and what to fill; {@code picture} out. */
final class FillFormat extends Format<SeedFiller, FillTask, PixelRecording> {
    private static final int SIDE = Raster.LARGEST_SIDE;
    private static final String ROW = "a text of 1 to " + SIDE + " characters";
    private static final Field<List<String>> PICTURE =
            Field.required("picture", Shape.list("rows", Shape.text(ROW, 1, 2 * SIDE), 1, SIDE))
                    .as(FieldKind.PICTURE);
    private static final Field<int[]> SEED =
            Field.required(
                            "seed",
                            Shape.described(
                                    Shape.wholes(2),
                                    Shape.list("whole numbers", Shape.whole(0, SIDE - 1), 2, 2)))
                    .as(FieldKind.SEED)
                    .in("pixels");
    private static final Field<String> WITH =
            Field.required("with", Shape.text("a text of one character", 1, 2));
    private static final Field<Integer> CONNECTIVITY =
            Field.required("connectivity", new Connectivity());
    private static final Field<?> FILLED =
            Field.required("picture", Shape.list(Shape.text())).as(FieldKind.PICTURE);

    FillFormat(Topic<SeedFiller, FillTask, PixelRecording> topic) {
        super(topic);
    }

    /** 4 or 8, refused with words of its own. */
    private record Connectivity() implements Shape<Integer> {
        @Override
        public Integer read(ValueSource in) throws IOException {
            return in.whole(Integer.MIN_VALUE, Integer.MAX_VALUE);
        }

        @Override
        public void write(Integer connectivity, ValueSink out) throws IOException {
            out.whole(connectivity);
        }

        @Override
        public void schema(ValueSink out) throws IOException {
            out.startObject();
            out.name("enum");
            out.wholes(4, 8);
            out.endObject();
        }
    }

    @Override
    public List<Field<?>> input() {
        return List.of(PICTURE, SEED, WITH, CONNECTIVITY);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(FILLED);
    }

    @Override
    public String reads() {
        return """
            {"picture":["....",...], "seed":[x,y], "with":"*", "connectivity":4 or 8}, a \
            picture being rows of characters""";
    }

    @Override
    public String answers() {
        return """
            {"picture":[...]}""";
    }

    @Override
    public FillTask read(Given given) {
        List<String> rows = given.get(PICTURE);
        int width = characters("/picture/0", rows.get(0));
        for (int y = 0; y < rows.size(); y++) requireWidth("/picture/" + y, rows.get(y), width);
        int[] seed = given.get(SEED);
        requireInside("/seed/0", seed[0], width);
        requireInside("/seed/1", seed[1], rows.size());
        String with = given.get(WITH);
        if (characters("/with", with) != 1)
            throw new InvalidInput("/with", "expected one character, got " + with);
        int connectivity = given.get(CONNECTIVITY);
        if (connectivity != 4 && connectivity != 8)
            throw new InvalidInput("/connectivity", "expected 4 or 8, got " + connectivity);
        return new FillTask(rows, seed[0], seed[1], with.codePointAt(0), connectivity);
    }

    @Override
    protected Given given(FillTask task) {
        return new Given()
                .with(PICTURE, task.rows())
                .with(SEED, new int[] {task.x(), task.y()})
                .with(WITH, Character.toString(task.with()))
                .with(CONNECTIVITY, task.connectivity());
    }

    /** The number of characters, those beyond 16 bits counted once. */
    private static int characters(String place, String text) {
        if (text.codePoints().anyMatch(c -> c >= 0xD800 && c <= 0xDFFF))
            throw new InvalidInput(place, "expected characters, got half of a surrogate pair");
        return text.codePointCount(0, text.length());
    }

    private static void requireWidth(String place, String row, int width) {
        if (characters(place, row) != width)
            throw new InvalidInput(
                    place,
                    "expected %d characters as /picture/0 has, got %d"
                            .formatted(width, characters(place, row)));
        if (width > SIDE)
            throw new InvalidInput(
                    place, "expected 1 to %d characters, got %d".formatted(SIDE, width));
    }

    private static void requireInside(String place, int value, int size) {
        if (value < 0 || value >= size)
            throw new InvalidInput(
                    place,
                    "expected a whole number from 0 to %d, got %d".formatted(size - 1, value));
    }

    /** {@inheritDoc} From outside one sees the picture, not the pixels in their order. */
    @Override
    public void write(FillTask task, PixelRecording pixels, ValueSink out) throws IOException {
        var picture = new TextPicture(task.rows());
        for (int i = 0; i < pixels.size(); i++)
            picture.write(pixels.x(i), pixels.y(i), task.with());
        write(picture, out);
    }

    private static void write(TextPicture picture, ValueSink out) throws IOException {
        out.name(FILLED.name());
        out.startArray();
        for (String row : picture.rows()) out.text(row);
        out.endArray();
    }

    private record Step(int y, int from, int to, int waiting) implements Written {
        @Override
        public void write(ValueSink out) throws IOException {
            out.whole("y", y);
            out.whole("from", from);
            out.whole("to", to);
            out.whole("decision", waiting);
        }
    }

    /** {@inheritDoc} The picture is the one that was filled, in whatever colours. */
    @Override
    protected Written answered(Call<SeedFiller> call, FillTask task) {
        var text = new TextPicture(task.rows());
        var picture = new WatchedPicture(text, new Endless(call.name(), text));
        if (!call.steps()) {
            call.method().fill(picture, task.x(), task.y(), task.with(), task.connectivity());
            return out -> write(text, out);
        }
        var steps = new ArrayList<Step>();
        TracedFill traced = call.stepped(TracedFill.class);
        traced.trace(
                picture,
                task.x(),
                task.y(),
                task.with(),
                task.connectivity(),
                (y, from, to, waiting) -> RecordedSteps.add(steps, new Step(y, from, to, waiting)));
        return out -> {
            write(text, out);
            RecordedSteps.deciding(traced.waitingMeans(), steps).write(out);
        };
    }

    /** Stops a method that writes more than twice as many pixels as the picture has. */
    private static final class Endless implements Pixels {
        private final String method;
        private final long most;
        private long writes;

        Endless(String method, TextPicture picture) {
            this.method = method;
            most = 2L * picture.width() * picture.height();
        }

        @Override
        public void plot(int x, int y) {
            if (++writes > most)
                throw new AnswerLimitReached(
                        method
                                + " does not end: it wrote more than "
                                + most
                                + " pixels, twice what the picture has");
        }
    }
}
