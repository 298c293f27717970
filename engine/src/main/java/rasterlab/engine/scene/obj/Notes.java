package rasterlab.engine.scene.obj;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Counts what was passed over, by kind, with the place of the first. */
final class Notes {
    /** Kinds beyond this are counted together: a damaged file may hold any number of keywords. */
    private static final int MOST_KINDS = 50;

    private static final String OTHERS = "other unknown keywords were passed over";

    private final Map<String, Note> notes = new LinkedHashMap<>();

    private static final class Note {
        private final String place;
        private long count;

        Note(String place) {
            this.place = place;
        }
    }

    /**
     * @param what was done, in the past tense
     * @param line where, or 0 for the file as a whole
     */
    void count(String what, String file, int line) {
        boolean room = notes.size() < MOST_KINDS || notes.containsKey(what);
        notes.computeIfAbsent(
                        room ? what : OTHERS, key -> new Note(line == 0 ? file : file + ":" + line))
                .count++;
    }

    void countKeyword(String keyword, TextLines lines) {
        count(
                "unknown '" + Words.shown(keyword) + "' was passed over",
                lines.file(),
                lines.number());
    }

    List<String> all() {
        List<String> all = new ArrayList<>();
        notes.forEach(
                (what, note) ->
                        all.add(
                                "%s: %s%s"
                                        .formatted(
                                                note.place,
                                                what,
                                                note.count == 1
                                                        ? ""
                                                        : ", " + note.count + " times")));
        return List.copyOf(all);
    }
}
