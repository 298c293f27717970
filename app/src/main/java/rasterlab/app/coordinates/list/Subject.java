package rasterlab.app.coordinates.list;

import java.util.List;
import java.util.Locale;
import rasterlab.app.coordinates.figure.Wireframe;
import rasterlab.engine.naming.Named;

/** The figure that is transformed. */
public enum Subject {
    SQUARE(Wireframe.square()),
    TRIANGLE(Wireframe.triangle()),
    HOUSE(Wireframe.house()),
    CUBE(Wireframe.cube()),
    /** Points of space by themselves, as an input of a topic has them. */
    POINTS(Wireframe.point());

    private final transient Wireframe wire;

    Subject(Wireframe wire) {
        this.wire = wire;
    }

    Wireframe wire() {
        return wire;
    }

    /** Lower-case name. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    static Subject named(String code) {
        return Named.find("subject", code, List.of(values()), Subject::code);
    }
}
