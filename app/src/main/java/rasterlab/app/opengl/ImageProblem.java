package rasterlab.app.opengl;

import java.util.List;

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
}
