package rasterlab.engine.transform;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** From eye space to the picture plane, which passes through the object's centre: d = ρ. */
public enum Projection {
    /**
     * Central: X = d·x/z, Y = d·y/z. With d = ρ, what lies at the object's centre keeps its size
     * while ρ changes the amount of perspective.
     */
    PERSPECTIVE,
    /**
     * X = x, Y = y: what the vase's program does, whose d and ρ never divide anything. Nothing is
     * too near, the eye is infinitely far.
     */
    PARALLEL;

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(Projection::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static Projection named(String name) {
        return Named.find("projection", name, List.of(values()), Projection::code);
    }
}
