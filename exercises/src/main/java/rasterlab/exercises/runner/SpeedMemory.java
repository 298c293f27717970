package rasterlab.exercises.runner;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalInt;
import rasterlab.exercises.Exercise;

/**
 * Remembers in which band of speed a source was, so that one near the end of a band does not go to
 * and fro between two with each new measurement. The sources that were graded last are known.
 */
final class SpeedMemory {
    private static final int MOST = 4096;

    private final Map<String, Integer> bands =
            new LinkedHashMap<>() {
                private static final long serialVersionUID = 1L;

                @Override
                protected boolean removeEldestEntry(Map.Entry<String, Integer> eldest) {
                    return size() > MOST;
                }
            };

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

    /**
     * @param key of exercise and source
     */
    synchronized OptionalInt band(String key) {
        Integer known = bands.get(key);
        return known == null ? OptionalInt.empty() : OptionalInt.of(known);
    }

    synchronized void keep(String key, int band) {
        bands.put(key, band);
    }
}
