package rasterlab.engine.pipeline;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/**
 * Pictures for two eyes.
 *
 * @param kind how they are shown
 * @param separation of the eyes in world units; {@link #USUAL} of ρ when 0
 */
public record Stereo(StereoMode kind, double separation) {
    /** The eyes' separation as a share of ρ unless another is given: about 2 degrees. */
    public static final double USUAL = 1 / 30.0;

    /** How two pictures are shown as one. */
    public enum StereoMode {
        /** The left eye's brightness in red, the right eye's in green and blue. */
        ANAGLYPH,
        /** The left eye's picture in the left half, the right eye's in the right half. */
        SIDE_BY_SIDE;

        /** Lower-case name with hyphens, as on the command line. */
        public String code() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }

        /** The names that {@link #named} knows. */
        public static List<String> names() {
            return Arrays.stream(values()).map(StereoMode::code).toList();
        }

        /**
         * @throws IllegalArgumentException for an unknown name; the message lists the known ones
         */
        public static StereoMode named(String name) {
            return Named.find("kind of stereo picture", name, List.of(values()), StereoMode::code);
        }
    }

    public Stereo {
        if (!(separation >= 0 && separation < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "eyes' separation must be finite and not negative, got " + separation);
    }

    /** The separation in world units for an eye at a distance. */
    public double separation(double rho) {
        return separation > 0 ? separation : USUAL * rho;
    }

    /** The separation under which the origin sees the eyes at an angle apart. */
    public static double separationAt(double degrees, double rho) {
        if (!(degrees > 0 && degrees < 180))
            throw new IllegalArgumentException(
                    "angle between the eyes must be above 0, below 180 degrees, got " + degrees);
        return 2 * rho * Math.tan(Math.toRadians(degrees) / 2);
    }
}
