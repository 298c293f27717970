package rasterlab.tests.grading;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Students' sources for the exercise {@code line-bresenham}. */
public final class Solutions {
    public static final String RIGHT = "Right";
    public static final String WRONG = "Wrong";
    public static final String FORBIDDEN = "Forbidden";
    public static final String ENDLESS = "Endless";

    private Solutions() {}

    public static String source(String name) {
        try (var stream = Solutions.class.getResourceAsStream(name + ".java")) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
