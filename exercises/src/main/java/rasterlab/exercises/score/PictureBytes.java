package rasterlab.exercises.score;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Supplier;

/**
 * The file of a picture: one for all languages, or another for those that write its numbers in a
 * way of their own, with a decimal comma.
 */
public final class PictureBytes {
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
