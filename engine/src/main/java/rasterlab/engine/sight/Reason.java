package rasterlab.engine.sight;

import java.util.List;
import java.util.Locale;

/**
 * Why something was decided.
 *
 * @param key names the reason, whatever the language
 * @param pattern the English sentence, a format string
 * @param values what stands in it, numbers and names
 */
public record Reason(String key, String pattern, List<Object> values) {
    public Reason {
        values = List.copyOf(values);
    }

    public static Reason of(String key, String pattern, Object... values) {
        return new Reason(key, pattern, List.of(values));
    }

    /** The sentence in English. */
    public String english() {
        return pattern.formatted(values.toArray());
    }

    /** The sentence in another language's pattern of the same values, with its numbers. */
    public String in(String other, Locale language) {
        return String.format(language, other, values.toArray());
    }
}
