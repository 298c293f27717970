package rasterlab.app.coordinates.list;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import rasterlab.app.coordinates.figure.Wire;
import rasterlab.engine.naming.Named;

/** What is transformed. */
public enum Subject {
    SQUARE(Wire.square()),
    TRIANGLE(Wire.triangle()),
    HOUSE(Wire.house()),
    CUBE(Wire.cube()),
    /** Points of space by themselves, as an input of a topic has them. */
    POINTS(Wire.point());

    private final transient Wire wire;

    Subject(Wire wire) {
        this.wire = wire;
    }

    Wire wire() {
        return wire;
    }

    /** Lower-case name. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    static Subject named(String code) {
        return Named.find("subject", code, List.of(values()), Subject::code);
    }

    static List<Subject> of(int dimension) {
        return Stream.of(values()).filter(each -> each.wire.dimension() == dimension).toList();
    }
}
