package rasterlab.exercises.runner;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;

/**
 * How a {@link Judge} runs children.
 *
 * @param compileLimit processor time for compiling one source
 * @param callLimit processor time for one call of the student's method
 * @param runLimit processor time for all calls of one submission together that were answered, each
 *     asked once
 * @param spares whether started children wait in reserve, which hides their start-up; off for a
 *     program that grades once and ends
 * @param speed how speed is measured
 * @param box which protection to look for
 * @param images folder in which images of Java for children are kept; none where they run on the
 *     running JDK
 */
public record JudgeSettings(
        Duration compileLimit,
        Duration callLimit,
        Duration runLimit,
        boolean spares,
        Speed speed,
        Protection box,
        Optional<Path> images) {
    /** How speed is measured; where nobody asks for its points, that takes time for nothing. */
    public enum Speed {
        /** Speed is measured until times are settled. */
        MEASURED,
        /**
         * Speed is tried with one batch, to see that it could be measured; it is told as one that
         * the machine did not let be.
         */
        ONCE,
        /** Speed is not measured; it is told as one that the machine did not let be. */
        OFF
    }

    /** Which protection to look for at start. */
    public enum Protection {
        /** Bubblewrap where it works, else process limits only. */
        STRONGEST,
        /** Process limits only, even where bubblewrap works. */
        PROCESS_LIMITS_ONLY
    }

    /** The wall time that goes with processor time on this machine. */
    Patience patience() {
        return Patience.ofThisMachine();
    }

    public JudgeSettings {
        positive("compileLimit", compileLimit);
        positive("callLimit", callLimit);
        positive("runLimit", runLimit);
    }

    /**
     * The settings of a server: 10 s to compile, 2 s a call, 8 s in all, spares on, strongest box.
     */
    public static JudgeSettings defaults() {
        return new JudgeSettings(
                Duration.ofSeconds(10),
                Duration.ofSeconds(2),
                Duration.ofSeconds(8),
                true,
                Speed.MEASURED,
                Protection.STRONGEST,
                Optional.empty());
    }

    /** The settings without children in reserve: for a program that grades once and ends. */
    public static JudgeSettings once() {
        return defaults().withSpares(false);
    }

    public JudgeSettings withSpares(boolean wanted) {
        return new JudgeSettings(compileLimit, callLimit, runLimit, wanted, speed, box, images);
    }

    public JudgeSettings withSpeed(Speed wanted) {
        return new JudgeSettings(compileLimit, callLimit, runLimit, spares, wanted, box, images);
    }

    /**
     * The settings with children on images of Java, which are made there where they are missing.
     */
    public JudgeSettings withImages(Path folder) {
        return new JudgeSettings(
                compileLimit, callLimit, runLimit, spares, speed, box, Optional.of(folder));
    }

    private static void positive(String name, Duration limit) {
        if (limit.isNegative() || limit.isZero())
            throw new IllegalArgumentException(name + " must be longer than 0 s, got " + limit);
    }
}
