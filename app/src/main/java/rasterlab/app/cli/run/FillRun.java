package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.Pixels;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.fill.FillTask;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.fill.TextPicture;
import rasterlab.engine.fill.TracedFill;
import rasterlab.engine.fill.WatchedPicture;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Topic;

/**
 * Topic {@code fill}: {@code picture}, {@code seed}, {@code with}, {@code connectivity}; {@code
 * picture} out.
 */
final class FillRun implements TopicRun {
    private static final int SIDE = Raster.LARGEST_SIDE;
    private static final String ROW = "a text of 1 to " + SIDE + " characters";
    private static final JsonField<List<String>> PICTURE =
            JsonField.required(
                    "picture",
                    json -> json.list("rows", row -> row.text(ROW, 1, 2 * SIDE), 1, SIDE));
    private static final JsonField<int[]> SEED =
            JsonField.required("seed", json -> json.integers(2));
    private static final JsonField<String> WITH =
            JsonField.required("with", json -> json.text("a text of one character", 1, 2));
    private static final JsonField<Integer> CONNECTIVITY =
            JsonField.required("connectivity", StrictJson::integer);

    private final FillTopic topic = new FillTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    FillRun(Watch watch) {
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
                {"picture":["....",...], "seed":[x,y], "with":"*", "connectivity":4 or 8}, a \
                picture being rows of characters""",
                """
                {"picture":[...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        FillTask task = task(StrictJson.object(text, length, PICTURE, SEED, WITH, CONNECTIVITY));
        SeedFiller filler = topic.method(method).implementation();
        return watch.call(method, () -> filled(method, filler, task, steps));
    }

    private static FillTask task(Given given) {
        List<String> rows = given.get(PICTURE);
        int width = characters("/picture/0", rows.get(0));
        for (int y = 0; y < rows.size(); y++) requireWidth("/picture/" + y, rows.get(y), width);
        int[] seed = given.get(SEED);
        requireInside("/seed/0", seed[0], width);
        requireInside("/seed/1", seed[1], rows.size());
        if (characters("/with", given.get(WITH)) != 1)
            throw Complaint.badInput("/with: expected one character, got " + given.get(WITH));
        int connectivity = given.get(CONNECTIVITY);
        if (connectivity != 4 && connectivity != 8)
            throw Complaint.badInput("/connectivity: expected 4 or 8, got " + connectivity);
        return new FillTask(rows, seed[0], seed[1], given.get(WITH).codePointAt(0), connectivity);
    }

    /** The number of characters, those beyond 16 bits counted once. */
    private static int characters(String place, String text) {
        if (text.codePoints().anyMatch(c -> c >= 0xD800 && c <= 0xDFFF))
            throw Complaint.badInput(place + ": expected characters, got half of a surrogate pair");
        return text.codePointCount(0, text.length());
    }

    private static void requireWidth(String place, String row, int width) {
        if (characters(place, row) != width)
            throw Complaint.badInput(
                    "%s: expected %d characters as /picture/0 has, got %d"
                            .formatted(place, width, characters(place, row)));
        if (width > SIDE)
            throw Complaint.badInput(
                    "%s: expected 1 to %d characters, got %d".formatted(place, SIDE, width));
    }

    private static void requireInside(String place, int value, int size) {
        if (value < 0 || value >= size)
            throw Complaint.badInput(
                    "%s: expected a whole number from 0 to %d, got %d"
                            .formatted(place, size - 1, value));
    }

    private record Step(int y, int from, int to, int waiting) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("y", y);
            json.writeNumberField("from", from);
            json.writeNumberField("to", to);
            json.writeNumberField("decision", waiting);
        }
    }

    private static Answer filled(String method, SeedFiller filler, FillTask task, boolean steps) {
        var text = new TextPicture(task.rows());
        var picture = new WatchedPicture(text, new Endless(method, text));
        var walked = new ArrayList<Step>();
        if (!steps) {
            filler.fill(picture, task.x(), task.y(), task.with(), task.connectivity());
            return json -> write(json, text);
        }
        TracedFill traced = Steps.of(method, filler, TracedFill.class);
        traced.trace(
                picture,
                task.x(),
                task.y(),
                task.with(),
                task.connectivity(),
                (y, from, to, waiting) -> Steps.add(walked, new Step(y, from, to, waiting)));
        return json -> {
            write(json, text);
            Steps.write(json, traced.waitingMeans(), walked, (out, step) -> step.write(out));
        };
    }

    private static void write(JsonGenerator json, TextPicture picture) throws IOException {
        json.writeArrayFieldStart("picture");
        for (String row : picture.rows()) json.writeString(row);
        json.writeEndArray();
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
                throw Complaint.gaveUp(
                        method
                                + " does not end: it wrote more than "
                                + most
                                + " pixels, twice what the picture has");
        }
    }
}
