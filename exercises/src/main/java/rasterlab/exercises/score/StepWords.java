package rasterlab.exercises.score;

import java.util.Locale;
import java.util.ResourceBundle;
import rasterlab.exercises.words.TopicWords;

/**
 * The names of the fields of steps and of inputs in one language, and the meaning of their words.
 */
public final class StepWords {
    private final ResourceBundle shared;

    private StepWords(ResourceBundle shared) {
        this.shared = shared;
    }

    /** The words in that language, or in English. */
    public static StepWords in(Locale language) {
        return new StepWords(
                ResourceBundle.getBundle(
                        StepWords.class.getPackageName() + ".steps",
                        language,
                        ResourceBundle.Control.getNoFallbackControl(
                                ResourceBundle.Control.FORMAT_PROPERTIES)));
    }

    /**
     * The name of a field: a word before the name that it has on a sheet, unless that is the word.
     *
     * @param topic whose own word comes first
     */
    public String label(String topic, String field) {
        String key = "field." + field;
        ResourceBundle own = TopicWords.of(topic, shared.getLocale());
        String word = own.containsKey(key) ? own.getString(key) : text(key, field);
        return word.equalsIgnoreCase(field) ? word : word + " (" + field + ")";
    }

    /** A value that is a word; itself where nothing is known of it. */
    public String word(String value) {
        return text("word." + value, value);
    }

    private String text(String key, String otherwise) {
        return shared.containsKey(key) ? shared.getString(key) : otherwise;
    }
}
