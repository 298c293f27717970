package rasterlab.app.canvas;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;

/** Breaks a sentence into lines between its words. */
public final class Wrapping {
    private Wrapping() {}

    /**
     * @param room the most that a line may measure; a longer word is broken too, where it can be
     *     behind a hyphen
     * @param measure of a line, in the unit of {@code room}
     */
    public static List<String> lines(String sentence, int room, ToIntFunction<String> measure) {
        var lines = new ArrayList<String>();
        String line = "";
        for (String word : sentence.split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (measure.applyAsInt(longer) <= room) {
                line = longer;
                continue;
            }
            if (!line.isEmpty()) lines.add(line);
            line = word;
            while (line.length() > 1 && measure.applyAsInt(line) > room) {
                int end = fitting(line, room, measure);
                lines.add(line.substring(0, end));
                line = line.substring(end);
            }
        }
        lines.add(line);
        return lines;
    }

    /** How many letters of a word make a line, at least 1 and less than all. */
    private static int fitting(String word, int room, ToIntFunction<String> measure) {
        int end = 1;
        while (end < word.length() - 1 && measure.applyAsInt(word.substring(0, end + 1)) <= room)
            end++;
        int hyphen = word.lastIndexOf('-', end - 1);
        return hyphen > 0 ? hyphen + 1 : end;
    }
}
