package rasterlab.exercises;

import java.util.Map;

/**
 * One step of help with an exercise: the idea, then where to look, then nearly the program in
 * words.
 *
 * @param text language code ("en", "ru") to Markdown text
 * @param cost in points, of what is handed in once it was shown
 */
public record Hint(Map<String, String> text, int cost) {
    /** The steps of an exercise that has hints. */
    public static final int STEPS = 3;

    public Hint {
        if (!text.containsKey("en"))
            throw new IllegalArgumentException(
                    "a hint needs a text in English ('en'), got only "
                            + String.join(", ", text.keySet()));
        if (cost < 0)
            throw new IllegalArgumentException("a hint costs 0 points or more, got " + cost);
        text = Map.copyOf(text);
    }

    /** The text in that language, or the English one where there is none. */
    public String text(String language) {
        return text.getOrDefault(language, text.get("en"));
    }
}
