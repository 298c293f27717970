package rasterlab.engine.fill;

import java.util.List;

/**
 * A picture, the pixel to fill from and the new colour: an input of topic {@code fill}.
 *
 * @param rows of characters, the top one first, all of one length; a character is a colour
 * @param with the new colour
 */
public record FillTask(List<String> rows, int x, int y, int with, int connectivity) {
    public FillTask {
        rows = List.copyOf(rows);
    }

    @Override
    public String toString() {
        return "from (%d, %d) with '%s', connectivity %d, in a picture of %d rows"
                .formatted(x, y, Character.toString(with), connectivity, rows.size());
    }
}
