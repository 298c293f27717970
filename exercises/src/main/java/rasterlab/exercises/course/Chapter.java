package rasterlab.exercises.course;

import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.words.TopicWords;

/**
 * A topic of the course with its exercises.
 *
 * @param exercises first those to write, then those to break, then those to predict; within a kind
 *     as the catalogue has them
 */
public record Chapter(String topic, List<Exercise> exercises) {
    public Chapter {
        exercises = List.copyOf(exercises);
    }

    /** The chapters of these exercises in the course's order; a topic without any has none. */
    public static List<Chapter> of(List<Exercise> exercises) {
        return Topics.names().stream()
                .map(topic -> new Chapter(topic, about(topic, exercises)))
                .filter(chapter -> !chapter.exercises.isEmpty())
                .toList();
    }

    private static List<Exercise> about(String topic, List<Exercise> exercises) {
        return exercises.stream()
                .filter(one -> one.topic().equals(topic))
                .sorted((one, other) -> one.form().compareTo(other.form()))
                .toList();
    }

    /** The heading, in that language ("en", "ru"). */
    public String title(String language) {
        return TopicWords.of(topic, Locale.forLanguageTag(language)).getString("title");
    }

    /** Name of the lab that prepares for the exercises, as that of its tab in the window. */
    public String lab() {
        return Topics.named(topic).lab();
    }

    /** The name of that lab's tab, in that language. */
    public String labTitle(String language) {
        return texts(language).getString("lab." + lab());
    }

    private static ResourceBundle texts(String language) {
        var onlyAsked =
                ResourceBundle.Control.getNoFallbackControl(
                        ResourceBundle.Control.FORMAT_PROPERTIES);
        return ResourceBundle.getBundle(
                "rasterlab.exercises.course.messages", Locale.forLanguageTag(language), onlyAsked);
    }
}
