package rasterlab.exercises.words;

import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;

/** Finds the words about a topic, which are read when they are first asked for. */
public final class TopicWords {
    private TopicWords() {}

    /**
     * The words about one topic; English where there are none in that language.
     *
     * @param topic its name as on the command line
     * @throws MissingResourceException when there is no such topic
     */
    public static ResourceBundle of(String topic, Locale language) {
        return ResourceBundle.getBundle(
                TopicWords.class.getPackageName() + "." + topic,
                language,
                ResourceBundle.Control.getNoFallbackControl(
                        ResourceBundle.Control.FORMAT_PROPERTIES));
    }
}
