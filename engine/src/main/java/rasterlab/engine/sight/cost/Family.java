package rasterlab.engine.sight.cost;

import java.util.Locale;
import java.util.Optional;

/** Methods whose work costs alike. */
public enum Family {
    /** The triangle pipeline on all cores. */
    PIPELINE,
    /** Faces painted whole, in some order. */
    PAINTER,
    /** A depth for each pixel, faces painted by spans. */
    BUFFER;

    /** The family of a visibility method that the planner may choose. */
    public static Family of(String visibility) {
        return switch (visibility) {
            case "pipeline" -> PIPELINE;
            case "z16", "z24", "z32", "zfloat", "reversed-z" -> BUFFER;
            default -> PAINTER;
        };
    }

    /** The family of a method, where its costs were measured. */
    public static Optional<Family> measured(String visibility) {
        return switch (visibility) {
            case "none", "back-face", "convex", "painter", "pipeline" ->
                    Optional.of(of(visibility));
            default -> of(visibility) == BUFFER ? Optional.of(BUFFER) : Optional.empty();
        };
    }

    /** Lower-case name, as in the table of costs. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }
}
