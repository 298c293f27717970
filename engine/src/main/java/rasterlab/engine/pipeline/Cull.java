package rasterlab.engine.pipeline;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** Which faces are left out by the side that the eye is on. */
public enum Cull {
    NONE,
    /** Faces seen from their inner side are left out. */
    BACK,
    /** Faces seen from their outer side are left out. */
    FRONT;

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(Cull::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static Cull named(String name) {
        return Named.find("way of culling", name, List.of(values()), Cull::code);
    }

    boolean keeps(boolean seenFromInside) {
        return this == NONE || (this == FRONT) == seenFromInside;
    }
}
