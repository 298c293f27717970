package rasterlab.exercises.score;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/** Reads the text of a picture of pixels, a character for each of them. */
public final class PixelRows {
    private static final Pattern ROW = Pattern.compile("[#.*+-]+");

    /** The beginning of the line on the part, above the rows. */
    private static final String PART = "columns ";

    private PixelRows() {}

    /**
     * The rows, without the line on the part where that is known; none where the text is not made
     * of rows.
     *
     * @param text of a picture
     * @param part which pixels it shows, where that is known
     */
    public static List<String> of(String text, Optional<PicturePart> part) {
        if (part.isPresent()) return part.get().rows(text);
        List<String> lines = text.lines().toList();
        boolean headed = text.startsWith(PART);
        boolean rows =
                lines.size() > (headed ? 1 : 0)
                        && lines.stream().skip(headed ? 1 : 0).allMatch(ROW.asMatchPredicate());
        return rows ? lines : List.of();
    }
}
