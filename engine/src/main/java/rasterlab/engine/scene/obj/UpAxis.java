package rasterlab.engine.scene.obj;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** Which axis of a model points up; up is z in a scene. */
public enum UpAxis {
    /** The model is turned about x: (x, y, z) becomes (x, −z, y). */
    Y,
    Z;

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(UpAxis::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static UpAxis named(String name) {
        return Named.find("axis that points up", name, List.of(values()), UpAxis::code);
    }

    /** The scene's coordinates of points or directions, x, y, z of each. */
    double[] toScene(double[] xyz) {
        if (this == Z) return xyz;
        var turned = new double[xyz.length];
        for (int i = 0; i < xyz.length; i += 3) {
            turned[i] = xyz[i];
            turned[i + 1] = -xyz[i + 2];
            turned[i + 2] = xyz[i + 1];
        }
        return turned;
    }
}
