package rasterlab.app.line;

import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelWindow;
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
        JsonFields fields = JsonFields.parse("input", json, "from", "to", "window");
        int[] from = fields.point("from");
        int[] to = fields.point("to");
        var whole = new Segment(from[0], from[1], to[0], to[1]);
        if (!fields.has("window")) return whole;
        int[] sides = fields.integers("window", 4);
        return whole.in(new PixelWindow(sides[0], sides[1], sides[2], sides[3]));
    }
}
