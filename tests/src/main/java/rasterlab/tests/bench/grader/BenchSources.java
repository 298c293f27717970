package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The sources that students hand in who load a server, and the exercise that these are for. */
final class BenchSources {
    static final String EXERCISE = "line-bresenham";
    private static final String RIGHT = "/rasterlab/tests/grading/Right.java";

    private static final String HEAD =
            """
            import rasterlab.contract.*;

            public final class Mine implements LineRasterizer {
                @Override
                public void draw(int x0, int y0, int x1, int y1, Pixels out) {
            """;
    private static final String TAIL = "    }\n}\n";

    /** Methods that never end, take all memory, and start threads without end. */
    static final List<String> BOMBS =
            List.of(
                    HEAD + "        while (true) { x0++; }\n" + TAIL,
                    HEAD
                            + "        var all = new java.util.ArrayList<int[]>();\n"
                            + "        while (true) all.add(new int[1 << 20]);\n"
                            + TAIL,
                    HEAD
                            + "        while (true) new Thread(() -> { while (true) { } }).start();\n"
                            + TAIL);

    private BenchSources() {}

    /** A source that is right. */
    static String right() {
        try (var stream = BenchSources.class.getResourceAsStream(RIGHT)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Sources of which each is graded otherwise: right, wrong, broken off, and not compiled. */
    static List<String> mixed() {
        return List.of(
                right(),
                HEAD + "        out.plot(x0, y0);\n" + TAIL,
                HEAD + "        throw new IllegalStateException();\n" + TAIL,
                HEAD + "        out.plot(x0);\n" + TAIL);
    }

    /** A source that differs from others of the same text, and means the same. */
    static String marked(String source, int number) {
        return source + "// " + number + "\n";
    }
}
