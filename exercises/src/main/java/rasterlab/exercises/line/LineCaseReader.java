package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.study.Hazard;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/**
 * Reads a case's input: the segment itself or the name of a hazard, or how to draw segments from a
 * seed.
 */
public final class LineCaseReader {
    private LineCaseReader() {}

    /**
     * @param seed draws the segments of a generated case, together with the case's name
     * @throws rasterlab.exercises.CatalogueException when a field is missing, unknown or out of
     *     range
     */
    public static LineCase read(Case one, long seed) {
        return one.generated()
                ? generated(one, place(one, "generate"), seed)
                : given(one, place(one, "input"));
    }

    private static Phrase place(Case one, String field) {
        return Phrase.of("field", Phrase.of("field.case", one.name()), field);
    }

    private static LineCase given(Case one, Phrase place) {
        JsonFields fields =
                JsonFields.parse(
                        place,
                        one.input(),
                        "hazard",
                        "from",
                        "to",
                        "alsoSwapped",
                        "strictTies",
                        "inOrder",
                        "firstPixels",
                        "mayRefuse");
        Segment segment = fields.has("hazard") ? hazard(fields) : segment(fields);
        // the order of pixels counts in every case; older files ask for it where they meant it
        fields.flag("inOrder", true);
        boolean swapped = fields.flag("alsoSwapped", false);
        LineCase read =
                new LineCase(
                        swapped ? List.of(segment, segment.reversed()) : List.of(segment),
                        fields.flag("strictTies", false),
                        fields.integer(
                                "firstPixels", 1, LineCase.MOST_PIXELS, LineCase.MOST_PIXELS),
                        fields.flag("mayRefuse", false));
        if (!fields.has("firstPixels") && read.cutShort(segment))
            throw fields.wrong("firstPixels", Phrase.of("field.cut", LineCase.MOST_PIXELS));
        return read;
    }

    private static Segment segment(JsonFields fields) {
        return fields.input(new LineTopic().format());
    }

    /** The segment of a hazard of the topic, so that lab, study and exercise have the same one. */
    private static Segment hazard(JsonFields fields) {
        for (String end : List.of("from", "to"))
            if (fields.has(end)) throw fields.wrong(end, Phrase.of("field.beside", "hazard"));
        List<Hazard<Segment>> hazards = new LineTopic().hazards();
        String name = fields.word("hazard", hazards.stream().map(Hazard::name).toList());
        return hazards.stream()
                .filter(hazard -> hazard.name().equals(name))
                .findFirst()
                .orElseThrow()
                .input();
    }

    private static LineCase generated(Case one, Phrase place, long seed) {
        JsonFields fields =
                JsonFields.parse(
                        place, one.input(), "octant", "shape", "count", "longest", "within");
        Random random = new Random(31 * seed + one.name().hashCode());
        LineShape shape = LineShape.read(fields);
        List<Segment> segments = new ArrayList<>();
        for (int left = fields.integer("count", 1, 50); left > 0; left--)
            shape.next(random).forEach(segments::add);
        return new LineCase(segments, shape.strictTies(), LineCase.MOST_PIXELS, false);
    }
}
