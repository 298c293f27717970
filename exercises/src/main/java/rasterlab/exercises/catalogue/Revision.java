package rasterlab.exercises.catalogue;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Map;
import rasterlab.exercises.runner.Judge;

/** A short name for everything that a grade depends on: the folder's files and the judge. */
final class Revision {
    private Revision() {}

    /**
     * The first 64 bits of a SHA-256 over the judge's version and each file's name, length and
     * content, as 16 hexadecimal digits.
     */
    static String of(Map<String, byte[]> files) {
        MessageDigest digest = sha256();
        digest.update(Judge.version().getBytes(StandardCharsets.UTF_8));
        files.forEach(
                (name, content) -> {
                    digest.update(
                            (name + '\0' + content.length + '\0').getBytes(StandardCharsets.UTF_8));
                    digest.update(content);
                });
        return HexFormat.of().formatHex(digest.digest(), 0, 8);
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java platform has SHA-256", e);
        }
    }
}
