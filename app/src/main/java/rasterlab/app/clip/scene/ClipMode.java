package rasterlab.app.clip.scene;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** The kinds of things that the lab clips. */
public enum ClipMode {
    SEGMENTS("clip-segment"),
    POLYGON("clip-polygon"),
    VOLUME("clip-volume");

    private final String topic;

    ClipMode(String topic) {
        this.topic = topic;
    }

    /** Name of the topic as on the command line. */
    public String topic() {
        return topic;
    }

    /** Lower-case name, the key of its texts. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static ClipMode coded(String code) {
        return Named.find("mode", code, List.of(values()), ClipMode::code);
    }
}
