package rasterlab.exercises.score;

import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.engine.Topics;
import rasterlab.exercises.words.TopicWords;

/**
 * The texts of reports in one language. Those on a topic, such as {@code mutant.line.MUTANT}, are
 * {@code mutant.MUTANT} of the topic's own words.
 *
 * @param general beside this class
 */
record ReportTexts(ResourceBundle general) {
    private static final Set<String> LANGUAGES = Set.of("en", "ru");
    private static final Pattern ON_A_TOPIC =
            Pattern.compile("(mutant|property|place)\\.([a-z-]+)\\.(.+)");

    /**
     * The texts in that language, or in English.
     *
     * @param language such as "ru"
     */
    static ReportTexts in(String language) {
        return new ReportTexts(
                ResourceBundle.getBundle(
                        "rasterlab.exercises.score.messages",
                        Locale.forLanguageTag(LANGUAGES.contains(language) ? language : "en"),
                        ResourceBundle.Control.getNoFallbackControl(
                                ResourceBundle.Control.FORMAT_PROPERTIES)));
    }

    boolean has(String key) {
        Place place = place(key);
        return place.texts.containsKey(place.key);
    }

    String text(String key) {
        Place place = place(key);
        return place.texts.getString(place.key);
    }

    Locale locale() {
        return general.getLocale();
    }

    /** Where a text stands. */
    private record Place(ResourceBundle texts, String key) {}

    private Place place(String key) {
        Matcher parts = ON_A_TOPIC.matcher(key);
        if (!parts.matches() || !Topics.names().contains(parts.group(2)))
            return new Place(general, key);
        ResourceBundle own = TopicWords.of(parts.group(2), locale());
        return new Place(own, parts.group(1) + "." + parts.group(3));
    }
}
