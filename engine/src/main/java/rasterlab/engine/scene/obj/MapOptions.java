package rasterlab.engine.scene.obj;

import java.util.List;
import java.util.Optional;

/** Reads what follows {@code map_Kd}: options, then the picture's file. */
final class MapOptions {
    private final TextLines lines;
    private final Words words;
    private final Notes notes;
    private final double[] offset = {0, 0};
    private final double[] scale = {1, 1};
    private boolean clamped;

    MapOptions(TextLines lines, Words words, Notes notes) {
        this.lines = lines;
        this.words = words;
        this.notes = notes;
    }

    /** Empty where no file is named. */
    Optional<ObjMaterial.Map> read() throws BrokenFileException {
        int at = 1;
        while (at < words.count() && isOption(at)) at = option(at);
        List<String> names = words.names(at);
        if (names.get(0).isEmpty()) {
            notes.count("'map_Kd' without a file's name was passed over", lines);
            return Optional.empty();
        }
        return Optional.of(
                new ObjMaterial.Map(
                        names,
                        lines.file() + ":" + lines.number(),
                        List.of(offset[0], offset[1]),
                        List.of(scale[0], scale[1]),
                        clamped));
    }

    /** A file's name may begin with a hyphen too, but then it has a point further on. */
    private boolean isOption(int word) {
        String text = words.get(word);
        return ReadingRules.ofOption(text).isPresent() || text.matches("-[A-Za-z]\\w*");
    }

    /** Reads an option and gives the word behind it. */
    private int option(int at) throws BrokenFileException {
        Optional<Rule> known = ReadingRules.ofOption(words.get(at));
        if (known.isEmpty()) {
            noteOption("unknown option '%s' was passed over", at);
            return behind(at, Integer.MAX_VALUE);
        }
        Rule rule = known.get();
        int end = behind(at, ReadingRules.mostWords(rule));
        if (rule == ReadingRules.OFFSET) numbers(at, end, rule, offset);
        else if (rule == ReadingRules.SCALE) numbers(at, end, rule, scale);
        else if (rule == ReadingRules.CLAMP)
            clamped = end > at + 1 && words.get(at + 1).equals("on");
        else noteOption("option '%s' was passed over", at);
        return end;
    }

    private void noteOption(String what, int at) {
        notes.count(what.formatted(Words.shown(words.get(at))), lines);
    }

    private void numbers(int at, int end, Rule rule, double[] into) throws BrokenFileException {
        for (int i = 0; i < into.length && at + 1 + i < end; i++)
            into[i] = words.number(at + 1 + i, rule);
        if (end == at + 1) words.noteUnread(words.count(), rule);
    }

    /**
     * The word behind an option's own: numbers, or one word where the option takes one. The last
     * word of a line is a file's name.
     */
    private int behind(int at, int most) {
        int end = at + 1;
        int last = Math.min(words.count() - 1, most == Integer.MAX_VALUE ? most : at + 1 + most);
        if (most == 1) return Math.max(end, last);
        while (end < last && !Double.isNaN(words.value(end))) end++;
        return end;
    }
}
