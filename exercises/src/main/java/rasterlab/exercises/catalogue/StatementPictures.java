package rasterlab.exercises.catalogue;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.engine.Topics;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.Picture;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.Call;
import rasterlab.exercises.graded.RightPicture;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Phrase;
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
    private final String topic;

    StatementPictures(ExerciseFolder folder, String topic) {
        this.folder = folder;
        this.topic = topic;
    }

    /** The name of a language's statement. */
    static String file(String language) {
        return "statement." + language + ".md";
    }

    /**
     * @param statements language code to Markdown text
     * @throws CatalogueException naming statement and picture, where one cannot be shown
     */
    Map<String, Picture> read(Map<String, String> statements) {
        Map<String, Picture> pictures = new LinkedHashMap<>();
        statements.forEach(
                (language, text) -> {
                    for (Matcher shown = SHOWN.matcher(text); shown.find(); )
                        pictures.computeIfAbsent(
                                shown.group(1), name -> picture(file(language), name));
                });
        return pictures;
    }

    private Picture picture(String statement, String name) {
        try {
            if (name.contains("/"))
                throw new CatalogueException(Phrase.of("picture.elsewhere", name));
            String source = name.replaceFirst("\\.png$", ".json");
            return !name.equals(source) && !folder.has(name) && folder.has(source)
                    ? drawn(source)
                    : Picture.of(name, folder.content(name));
        } catch (CatalogueException e) {
            throw new CatalogueException(
                    Phrase.of("folder.at", folder.place(statement), e.said()), e);
        }
    }

    private TopicGrading grading() {
        if (!TopicGradings.names().contains(topic))
            throw new CatalogueException(Phrase.of("picture.undrawn", topic));
        return TopicGradings.named(topic);
    }

    /**
     * The right answer to the one input of a file, which is read now and drawn when it is shown.
     */
    private Picture drawn(String source) {
        byte[] content = folder.content(source);
        var input = new String(content, StandardCharsets.UTF_8);
        var shown = new Case(source, Map.of(), Kind.ACCURACY, Disclosure.OPEN, 0, input, false);
        List<Call> calls = grading().calls(shown, new Tolerance(false), 0);
        return Picture.drawn(source, content, () -> drawn(topic, calls.get(0)));
    }

    private static byte[] drawn(String topic, Call one) {
        return new RightPicture(Topics.named(topic).format(), one.input(), one.exact()).png();
    }
}
