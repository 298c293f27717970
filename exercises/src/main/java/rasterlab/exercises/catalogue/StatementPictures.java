package rasterlab.exercises.catalogue;

import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.engine.Topics;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.StatementPicture;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.graded.RightPicture;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.score.PictureBytes;
import rasterlab.exercises.topic.TopicGradings;

/**
 * The pictures that statements show: files of the exercise's folder. Where there is no {@code
 * window.png} but a {@code window.json} with the input of a case, the right answer to that input is
 * drawn. No grade depends on pictures, so they are no part of the revision.
 */
final class StatementPictures {
    /** {@code ![words](file)} or {@code ![words](file "title")}. */
    private static final Pattern SHOWN = Pattern.compile("!\\[[^\\]]*\\]\\(\\s*<?([^\\s)>]*)");

    private final ExerciseFolder folder;
    private final Optional<String> topic;

    /**
     * @param topic of the inputs that are drawn; where it is empty, none is
     */
    StatementPictures(ExerciseFolder folder, Optional<String> topic) {
        this.folder = folder;
        this.topic = topic;
    }

    /** The name of a language's statement. */
    static String file(String language) {
        return "statement." + language + ".md";
    }

    /**
     * The pictures that can be shown, by the names in the statements.
     *
     * @param statements language code to Markdown text
     * @param faults takes statement and picture, where one cannot be shown
     */
    Map<String, StatementPicture> read(Map<String, String> statements, Faults faults) {
        Map<String, StatementPicture> pictures = new LinkedHashMap<>();
        statements.forEach(
                (language, text) -> {
                    Set<String> looked = new HashSet<>(pictures.keySet());
                    for (Matcher shown = SHOWN.matcher(text); shown.find(); ) {
                        String name = shown.group(1);
                        if (looked.add(name))
                            faults.tried(() -> picture(file(language), name))
                                    .flatMap(one -> one)
                                    .ifPresent(one -> pictures.put(name, one));
                    }
                });
        return pictures;
    }

    /** A picture; empty where no topic is known to draw it. */
    private Optional<StatementPicture> picture(String statement, String name) {
        try {
            if (name.contains("/"))
                throw new CatalogueException(Phrase.of("picture.elsewhere", name));
            String source = name.replaceFirst("\\.png$", ".json");
            return !name.equals(source) && !folder.has(name) && folder.has(source)
                    ? topic.map(one -> drawn(one, source))
                    : Optional.of(StatementPicture.of(name, folder.content(name)));
        } catch (CatalogueException e) {
            throw new CatalogueException(
                    Phrase.of("folder.at", folder.place(statement), e.phrase()), e);
        }
    }

    private static TopicGrading grading(String topic) {
        if (!TopicGradings.names().contains(topic))
            throw new CatalogueException(Phrase.of("picture.undrawn", topic));
        return TopicGradings.named(topic);
    }

    /**
     * The right answer to the one input of a file, which is read now and drawn when it is shown.
     */
    private StatementPicture drawn(String topic, String source) {
        byte[] content = folder.content(source);
        var input = new String(content, StandardCharsets.UTF_8);
        var shown =
                new Case(source, Map.of(), Criterion.ACCURACY, Disclosure.OPEN, 0, input, false);
        List<GradedCall> calls = grading(topic).calls(shown, new ExerciseTolerance(false), 0);
        return StatementPicture.drawn(source, content, () -> drawn(topic, calls.get(0)));
    }

    private static PictureBytes drawn(String topic, GradedCall one) {
        return new RightPicture(Topics.named(topic).format(), one.input(), one.exact()).drawn();
    }
}
