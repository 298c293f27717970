package rasterlab.engine.pipeline.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** The treatment of the parts of edges that faces hide. */
public enum HiddenLines {
    REMOVED,
    DASHED,
    SHOWN;

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(HiddenLines::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static HiddenLines named(String name) {
        return Named.find("way with hidden lines", name, List.of(values()), HiddenLines::code);
    }
}
