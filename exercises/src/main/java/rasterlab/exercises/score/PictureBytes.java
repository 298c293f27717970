package rasterlab.exercises.score;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonValue;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;

/**
 * The file of a picture: one for all languages, or another for those that write its numbers in a
 * way of their own, with a decimal comma.
 */
public final class PictureBytes {
    /** The name in a kept file of the bytes for all languages that have none of their own. */
    private static final String USUAL = "usual";

    private final byte[] usual;
    private final Map<String, Supplier<byte[]>> own;
    private final Map<String, byte[]> drawn = new HashMap<>();

    private PictureBytes(byte[] usual, Map<String, Supplier<byte[]>> own) {
        this.usual = usual.clone();
        this.own = Map.copyOf(own);
    }

    /** One file for all languages. */
    public static PictureBytes alike(byte[] usual) {
        return of(usual, Map.of());
    }

    /**
     * A file for most languages, and what draws those of others when they are asked for first.
     *
     * @param own by the codes of these languages, such as "ru"
     */
    public static PictureBytes of(byte[] usual, Map<String, Supplier<byte[]>> own) {
        return new PictureBytes(usual, own);
    }

    /**
     * @throws IllegalArgumentException where the usual bytes are missing
     */
    @JsonCreator
    private static PictureBytes kept(Map<String, byte[]> files) {
        if (files.get(USUAL) == null)
            throw new IllegalArgumentException("a picture must have '" + USUAL + "' bytes");
        Map<String, Supplier<byte[]>> own = new HashMap<>();
        files.forEach(
                (language, bytes) -> {
                    if (!language.equals(USUAL)) own.put(language, () -> bytes);
                });
        return of(files.get(USUAL), own);
    }

    @JsonValue
    private Map<String, byte[]> toKeep() {
        Map<String, byte[]> files = new TreeMap<>();
        own.keySet().forEach(language -> files.put(language, in(language)));
        files.put(USUAL, usual.clone());
        return files;
    }

    /** Whether that language has a file that others have not. */
    public boolean hasOwn(String language) {
        return own.containsKey(language);
    }

    /**
     * A copy of the file that is shown in that language.
     *
     * @param language such as "ru"
     */
    public synchronized byte[] in(String language) {
        if (!hasOwn(language)) return usual.clone();
        return drawn.computeIfAbsent(language, one -> own.get(one).get()).clone();
    }
}
