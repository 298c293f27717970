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
 * {@code mutant.MUTANT} of the topic's own words; {@code faults.line.METHOD} are those that {@code
 * METHOD.failures} there lists, or {@code told.METHOD} where some of them show on no input of an
 * exercise, and {@code fault.line.METHOD} is the first of them.
 *
 * @param general beside this class
 */
record ReportTexts(ResourceBundle general) {
    private static final Set<String> LANGUAGES = Set.of("en", "ru");
    private static final Pattern ON_A_TOPIC =
            Pattern.compile(
                    "(mutant|slip|property|hazard|place|faults?|decided|rule|bound)\\.([a-z-]+)\\.(.+)");

    /** The beginning of the keys of texts that no new report has. */
    private static final String WAS = "was.";

    /** The number of characters beyond which only the first faults are told. */
    private static final int LONG_FAULTS = 120;

    /** A first fault that is longer is told up to its first comma. */
    private static final int LONG_FAULT = 60;

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

    /** Whether a stored report may have that key, though no new one does. */
    boolean had(String key) {
        return has(key) || general.containsKey(WAS + key);
    }

    String text(String key) {
        if (!has(key) && had(key)) return general.getString(WAS + key);
        Place place = place(key);
        String text = place.texts.getString(place.key);
        if (place.key.equals(key)) return text;
        if (key.startsWith("faults.")) return first(text, "; ", LONG_FAULTS);
        if (key.startsWith("fault.")) return first(first(text, "; ", 0), ", ", LONG_FAULT);
        return key.startsWith("hazard.") && text.endsWith(".")
                ? text.substring(0, text.length() - 1)
                : text;
    }

    /** The first parts of a text that make no more than that many characters, but one at least. */
    private static String first(String text, String between, int most) {
        if (text.length() <= most) return text;
        int end = text.lastIndexOf(between, most);
        if (end < 0) end = text.indexOf(between);
        return end < 0 ? text : text.substring(0, end);
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
        if (!parts.group(1).startsWith("fault"))
            return new Place(own, parts.group(1) + "." + parts.group(3));
        String told = "told." + parts.group(3);
        return new Place(own, own.containsKey(told) ? told : parts.group(3) + ".failures");
    }
}
