package rasterlab.tests.grading;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Students' sources for the exercise {@code line-bresenham}. */
final class Solutions {
    static final String RIGHT = "Right";
    static final String WRONG = "Wrong";
    static final String FORBIDDEN = "Forbidden";
    static final String ENDLESS = "Endless";

    private Solutions() {}

    static String source(String name) {
        try (var stream = Solutions.class.getResourceAsStream(name + ".java")) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
