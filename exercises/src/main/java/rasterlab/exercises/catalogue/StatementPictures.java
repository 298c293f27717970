package rasterlab.exercises.catalogue;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Picture;
import rasterlab.exercises.score.Phrase;

/**
 * The pictures that statements show: files of the exercise's folder. No grade depends on them, so
 * they are no part of the revision.
 */
final class StatementPictures {
    /** {@code ![words](file)} or {@code ![words](file "title")}. */
    private static final Pattern SHOWN = Pattern.compile("!\\[[^\\]]*\\]\\(\\s*<?([^\\s)>]*)");

    private final ExerciseFolder folder;

    StatementPictures(ExerciseFolder folder) {
        this.folder = folder;
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
            return Picture.of(name, folder.content(name));
        } catch (CatalogueException e) {
            throw new CatalogueException(
                    Phrase.of("folder.at", folder.place(statement), e.said()), e);
        }
    }
}
