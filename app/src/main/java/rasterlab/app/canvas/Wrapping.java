package rasterlab.app.canvas;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;

/** Breaks a sentence into lines between its words. */
public final class Wrapping {
    private Wrapping() {}

    /**
     * @param room the most that a line may measure; a single longer word still gets its line
     * @param measure of a line, in the unit of {@code room}
     */
    public static List<String> lines(String sentence, int room, ToIntFunction<String> measure) {
        var lines = new ArrayList<String>();
        String line = "";
        for (String word : sentence.split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (line.isEmpty() || measure.applyAsInt(longer) <= room) {
                line = longer;
            } else {
                lines.add(line);
                line = word;
            }
        }
        lines.add(line);
        return lines;
    }
}
