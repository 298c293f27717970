package rasterlab.tests.bench.grader;

import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** A part of the server's benchmark, which can be run without the others. */
public enum GraderPart {
    SINGLE,
    CLASS,
    BOMBS,
    SOCKETS,
    BURST,
    DISK,
    READONLY,
    LOCKED,
    DATABASE,
    CLOCK,
    FILES,
    KILLS;

    /** Loads of one server, each put on what the ones before left. */
    static final Set<GraderPart> LOADS =
            Collections.unmodifiableSet(EnumSet.of(CLASS, BOMBS, SOCKETS, BURST));

    /** Faults of the machine under a server. */
    static final Set<GraderPart> FAULTS = Collections.unmodifiableSet(EnumSet.range(DISK, FILES));

    /** The name by which it is asked for. */
    String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static List<String> words() {
        return Stream.of(values()).map(GraderPart::word).toList();
    }

    /** The first name, in a list with commas, that no part has. */
    public static Optional<String> unknownIn(String list) {
        return names(list).filter(name -> !words().contains(name)).findFirst();
    }

    public static Set<GraderPart> all() {
        return EnumSet.allOf(GraderPart.class);
    }

    /** The parts that a list with commas names. */
    public static Set<GraderPart> in(String list) {
        List<String> named = names(list).toList();
        Set<GraderPart> chosen = EnumSet.noneOf(GraderPart.class);
        for (GraderPart part : values()) if (named.contains(part.word())) chosen.add(part);
        return chosen;
    }

    private static Stream<String> names(String list) {
        return Stream.of(list.split(",", -1)).map(String::strip);
    }
}
