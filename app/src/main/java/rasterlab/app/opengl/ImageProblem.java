package rasterlab.app.opengl;

import java.util.List;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;

/**
 * Why an image of the user is no texture.
 *
 * @param key of the sentence, behind {@code problem.}
 * @param arguments of the sentence
 */
public record ImageProblem(String key, List<Object> arguments) {
    static ImageProblem of(String key, Object... arguments) {
        return new ImageProblem(key, List.of(arguments));
    }

    /** The arguments, the reader's own words among them in that language where it is known. */
    Object[] said(Language language) {
        return arguments.stream()
                .map(each -> each instanceof String text ? Complaints.said(language, text) : each)
                .toArray();
    }
}
