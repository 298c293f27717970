package rasterlab.engine.scene.obj;

import java.util.ArrayList;
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

    /** The first word that the last option has no room for. */
    private int room;

    MapOptions(TextLines lines, Words words, Notes notes) {
        this.lines = lines;
        this.words = words;
        this.notes = notes;
    }

    /** Reads a map; empty where no file is named. */
    Optional<ObjMaterial.Map> read() throws BrokenFileException {
        int at = 1;
        while (at < words.count() && isOption(at)) at = option(at);
        List<String> names = names(at);
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

    /**
     * The file's name from a word on in all ways that it can be meant: words that the last option
     * has room for may be numbers that cannot be read.
     */
    private List<String> names(int from) {
        List<String> names = new ArrayList<>(words.names(from));
        for (int word = from + 1; word <= room; word++) names.addAll(words.names(word));
        return names;
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
            room = 0;
            return behindAny(at);
        }
        Rule rule = known.get();
        int most = ReadingRules.mostWords(rule);
        int end = behind(at, most);
        room = most == 1 ? 0 : Math.min(words.count() - 1, at + 1 + most);
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
        for (int i = 0; at + 1 + i < end; i++) {
            double number = words.number(at + 1 + i, rule);
            if (i < into.length) into[i] = number;
        }
        if (end == at + 1) words.noteUnread(words.count(), rule);
    }

    /**
     * The word behind an option's own: numbers, those that cannot be read among them, or one word
     * where the option takes one. The last word of a line is a file's name, and the name of another
     * option ends the numbers.
     */
    private int behind(int at, int most) {
        int last = Math.min(words.count() - 1, at + 1 + most);
        int end = at + 1;
        for (int word = at + 1; word < last && !endsNumbers(word, most); word++)
            if (most == 1 || words.isMeantAsNumber(word)) end = word + 1;
        return end;
    }

    private boolean endsNumbers(int word, int most) {
        return most > 1 && ReadingRules.ofOption(words.get(word)).isPresent();
    }

    /** The word behind an unknown option and the numbers that follow it. */
    private int behindAny(int at) {
        int end = at + 1;
        while (end < words.count() - 1 && words.isMeantAsNumber(end)) end++;
        return end;
    }
}
