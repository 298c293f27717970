package rasterlab.engine.scene.obj;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/** Counts what was passed over, by kind, with the place of the first. */
final class Notes {
    /** Kinds beyond this are counted together: a damaged file may hold any number of keywords. */
    private static final int MOST_KINDS = 50;

    private static final String OTHERS = "other unknown keywords were passed over";

    private final Map<Object, Note> notes = new LinkedHashMap<>();

    private Optional<LeftOut> firstLeftOut = Optional.empty();

    /** A row of which nothing is drawn, and why. */
    record LeftOut(int line, String why) {}

    private static final class Note {
        private final String place;
        private final String what;
        private long count;

        Note(String place, String what) {
            this.place = place;
            this.what = what;
        }
    }

    /**
     * @param what was done, in the past tense
     */
    void count(String what, TextLines lines) {
        count(what, what, lines);
    }

    /**
     * @param kind what is counted together
     * @param what was done with the first of the kind
     */
    void count(Object kind, String what, TextLines lines) {
        count(kind, () -> what, lines);
    }

    /**
     * @param what is asked for the first of the kind only
     */
    void count(Object kind, Supplier<String> what, TextLines lines) {
        count(kind, what, lines.file() + ":" + lines.number());
    }

    /**
     * Counts a face, line or point that is not drawn.
     *
     * @param kind what is counted together
     */
    void leaveOut(Object kind, String why, TextLines lines) {
        if (firstLeftOut.isEmpty()) firstLeftOut = Optional.of(new LeftOut(lines.number(), why));
        count(kind, why, lines);
    }

    /** The first row that {@link #leaveOut} was told of. */
    Optional<LeftOut> firstLeftOut() {
        return firstLeftOut;
    }

    /**
     * Counts so many at once.
     *
     * @param kind what is counted together
     */
    void countAt(String place, Object kind, String what, long times) {
        count(kind, () -> what, place);
        notes.getOrDefault(kind, notes.get(OTHERS)).count += times - 1;
    }

    /** Counts what is true of a file as a whole. */
    void countIn(String file, String what) {
        count(what, () -> what, file);
    }

    private void count(Object kind, Supplier<String> what, String place) {
        Note known = notes.get(kind);
        if (known == null && notes.size() < MOST_KINDS)
            notes.put(kind, known = new Note(place, what.get()));
        else if (known == null)
            known = notes.computeIfAbsent(OTHERS, key -> new Note(place, OTHERS));
        known.count++;
    }

    void countKeyword(String keyword, TextLines lines) {
        count("unknown '" + Words.shown(keyword) + "' was passed over", lines);
    }

    List<String> all() {
        List<String> all = new ArrayList<>();
        for (Note note : notes.values())
            all.add(
                    "%s: %s%s"
                            .formatted(
                                    note.place,
                                    note.what,
                                    note.count == 1 ? "" : " (" + note.count + " times)"));
        return List.copyOf(all);
    }
}
