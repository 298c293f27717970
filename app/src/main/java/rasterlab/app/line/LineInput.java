package rasterlab.app.line;

import rasterlab.engine.format.Field;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.json.JsonFields;

/** An input of topic {@code line} as JSON: {@code from}, {@code to}, optional {@code window}. */
public final class LineInput {
    private LineInput() {}

    /**
     * The segment.
     *
     * @throws IllegalArgumentException naming the field, what is there and what is allowed
     */
    public static Segment read(String json) {
        var format = new LineTopic().format();
        String[] known = format.input().stream().map(Field::name).toArray(String[]::new);
        try {
            return JsonFields.parse("input", json, known).input(format);
        } catch (InvalidInput invalid) {
            throw new IllegalArgumentException(invalid.reason(), invalid);
        }
    }
}
