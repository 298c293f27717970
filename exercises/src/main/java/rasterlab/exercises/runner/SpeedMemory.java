package rasterlab.exercises.runner;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.OptionalInt;
import rasterlab.exercises.Exercise;

/**
 * Remembers in which band of speed a source was, so that one near the end of a band does not go to
 * and fro between two with each new measurement. Several threads may use it at once.
 */
public interface SpeedMemory {
    /**
     * The band, 0 being the best, in which that source was when it was last measured.
     *
     * @param key of exercise and source, as {@link #key} has it
     */
    OptionalInt band(String key);

    /** Takes note of a measurement that settled. */
    void keep(String key, int band);

    /** A memory that lasts as long as the process and knows the sources that were graded last. */
    static SpeedMemory ofProcess() {
        return new ProcessSpeedMemory();
    }

    /** The hash that tells one source from another, whatever its length. */
    static String key(Exercise exercise, String source) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            byte[] hash = digest.digest(source.getBytes(StandardCharsets.UTF_8));
            return exercise.id() + ' ' + exercise.revision() + ' ' + HexFormat.of().formatHex(hash);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java platform has SHA-256", e);
        }
    }
}
