package rasterlab.exercises.line;

import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Stream;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/** Draws segments of one shape. */
final class LineShape {
    private static final int OCTANTS = 8;

    /** So that an end, too, is an int. */
    private static final int FARTHEST = 1_000_000_000;

    /** A shape whose segments take turns through all directions that it has. */
    private enum Kind {
        ANY,
        HORIZONTAL,
        VERTICAL,
        DIAGONAL,
        POINT,
        /** At least one pixel of each segment is a tie; each segment comes with its reverse. */
        TIES
    }

    private final Kind kind;
    private final int longest;
    private final int within;
    private int octant;
    private final boolean turning;

    private LineShape(Kind kind, int octant, int longest, int within) {
        this.kind = kind;
        this.octant = Math.max(1, octant);
        this.turning = octant == 0;
        this.longest = longest;
        this.within = within;
    }

    static LineShape read(JsonFields fields) {
        int longest = fields.integer("longest", 2, 1000);
        int within = fields.integer("within", 0, FARTHEST);
        if (!fields.has("shape"))
            return new LineShape(Kind.ANY, fields.integer("octant", 1, OCTANTS), longest, within);
        if (fields.has("octant")) throw fields.wrong("octant", Phrase.of("field.beside", "shape"));
        List<String> words =
                Stream.of(Kind.values()).map(kind -> kind.name().toLowerCase(Locale.ROOT)).toList();
        Kind kind = Kind.valueOf(fields.word("shape", words).toUpperCase(Locale.ROOT));
        return new LineShape(kind, 0, longest, within);
    }

    /** Whether a tie must go to the smaller coordinate. */
    boolean strictTies() {
        return kind == Kind.TIES;
    }

    /** One segment; of ties two. */
    List<Segment> next(Random random) {
        int x = random.nextInt(2 * within + 1) - within;
        int y = random.nextInt(2 * within + 1) - within;
        int along = 2 + random.nextInt(longest - 1);
        int across = random.nextInt(along + 1);
        Segment segment =
                switch (kind) {
                    case ANY -> inOctant(x, y, along, across);
                    case HORIZONTAL ->
                            new Segment(x, y, octant % 2 == 0 ? x + along : x - along, y);
                    case VERTICAL -> new Segment(x, y, x, octant % 2 == 0 ? y + along : y - along);
                    case DIAGONAL -> inOctant(x, y, along, along);
                    case POINT -> new Segment(x, y, x, y);
                    case TIES -> inOctant(x, y, 2 * along, 2 * (across / 2) + 1);
                };
        if (turning) octant = octant % OCTANTS + 1;
        return kind == Kind.TIES ? List.of(segment, segment.reversed()) : List.of(segment);
    }

    /**
     * Octant k has directions from (k − 1)·45° to k·45°, counted from the x axis towards the y
     * axis, which grows down.
     */
    private Segment inOctant(int x, int y, int along, int across) {
        boolean steep = octant == 2 || octant == 3 || octant == 6 || octant == 7;
        int dx = steep ? across : along;
        int dy = steep ? along : across;
        boolean left = octant >= 3 && octant <= 6;
        boolean up = octant >= 5;
        return new Segment(x, y, left ? x - dx : x + dx, up ? y - dy : y + dy);
    }
}
