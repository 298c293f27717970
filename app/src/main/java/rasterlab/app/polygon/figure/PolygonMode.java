package rasterlab.app.polygon.figure;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** The task that the lab solves for a polygon. */
public enum PolygonMode {
    TRIANGLE("point-in-triangle", false),
    POLYGON("point-in-polygon", false),
    TRIANGULATION("triangulate", false),
    FILL("polygon-fill", true),
    SEED("fill", true);

    private final String topic;
    private final boolean raster;

    PolygonMode(String topic, boolean raster) {
        this.topic = topic;
        this.raster = raster;
    }

    /** Name of the topic as on the command line. */
    public String topic() {
        return topic;
    }

    /** Whether the plane is one of pixels, y down. */
    public boolean raster() {
        return raster;
    }

    /** Whether points are judged. */
    public boolean judges() {
        return this == TRIANGLE || this == POLYGON;
    }

    /** Lower-case name, the key of its texts. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static PolygonMode coded(String code) {
        return Named.find("mode", code, List.of(values()), PolygonMode::code);
    }
}
