package rasterlab.app.exercise.panel;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import rasterlab.app.exercise.outcome.CaseDrawing;
import rasterlab.exercises.score.PicturePart;

/**
 * Where a case's pictures stand, and which part of them there is room for.
 *
 * @param part in the pictures' pixels
 * @param words below the pictures, which part it is, in lines; none where it is all
 */
public record PlacedCase(Rectangle part, NamedPictures pictures, List<String> words) {
    /**
     * Each pixel is at least so many view units wide, where the room has place for some of them.
     */
    private static final int CLEAR = 3;

    /** More would leave the pictures no room. */
    private static final int MOST_LINES = 6;

    /**
     * The things that are to be placed.
     *
     * @param whole all of each picture, with the type and names
     * @param partText a part in words
     */
    record CaseToPlace(
            CaseDrawing drawing,
            NamedPictures.PicturesToPlace whole,
            Function<PicturePart, String> partText) {
        /** The case placed in the room; empty where the names have no room. */
        Optional<PlacedCase> in(Dimension room) {
            for (int lines = 0; lines < MOST_LINES; lines++) {
                Optional<PlacedCase> placed = above(lines, room);
                if (placed.isEmpty() || placed.get().words().size() <= lines) return placed;
            }
            return above(MOST_LINES, room);
        }

        private Optional<PlacedCase> above(int lines, Dimension room) {
            FontMetrics metrics = whole.metrics().apply(whole.type());
            int below = lines == 0 ? 0 : NamedPictures.ABOVE_NAME + lines * metrics.getHeight();
            var left = new Dimension(room.width, room.height - below);
            Dimension size = drawing.divisible() ? whole.part(CLEAR, left) : drawing.pixels();
            CaseDrawing.PictureCrop cut = drawing.cut(size);
            List<String> words =
                    cut.part()
                            .map(part -> lines(partText.apply(part), metrics, room.width))
                            .orElse(List.of());
            return whole.of(size)
                    .in(left)
                    .map(pictures -> new PlacedCase(cut.place(), pictures, words));
        }
    }

    /** The lines of a text broken at spaces: a range of columns stays whole. */
    private static List<String> lines(String said, FontMetrics metrics, int width) {
        var lines = new ArrayList<String>();
        String line = "";
        for (String word : said.split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (!line.isEmpty() && metrics.stringWidth(longer) > width) {
                lines.add(line);
                line = word;
            } else {
                line = longer;
            }
        }
        lines.add(line);
        return lines;
    }
}
