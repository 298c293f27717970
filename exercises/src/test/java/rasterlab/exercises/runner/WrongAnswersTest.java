package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;

/**
 * A value that is no answer is told to the student in both languages, whatever is wrong with it.
 */
@Tag("slow")
class WrongAnswersTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource({"shades", "segments", "sides"})
    void isTold(String id, String body, String verdict, String said, String russian)
            throws Exception {
        CaseReport first =
                JUDGE.grade(Catalogue.builtIn().named(id), source(id, body), CaseSelection.open())
                        .cases()
                        .get(0);
        assertEquals(verdict, first.verdict().code(), first.message());
        assertTrue(first.message().contains(said), first.message());
        String translated = first.explanation().in("ru");
        assertTrue(translated.contains(russian), translated);
    }

    private static String source(String id, String body) {
        String head =
                switch (id) {
                    case "shade-face" ->
                            "FaceShader { public double[] shade(LitFace face, double[] weights)";
                    case "clip-segment" ->
                            "SegmentClipper { public void clip(double xmin, double ymin, double xmax,"
                                    + " double ymax, double x0, double y0, double x1, double y1,"
                                    + " SegmentSink out)";
                    default ->
                            "PointInTriangle { public boolean contains(double ax, double ay,"
                                    + " double bx, double by, double cx, double cy, double x, double y)";
                };
        return "import rasterlab.contract.*;\npublic class Mine implements "
                + head
                + " {\n"
                + body
                + "\n} }\n";
    }

    private static Arguments of(
            String name, String id, String body, String verdict, String said, String russian) {
        return argumentSet(name, id, body, verdict, said, russian);
    }

    static Stream<Arguments> shades() {
        String id = "shade-face";
        return Stream.of(
                of("null", id, "return null;", "wrong", "it returns null", "null"),
                of(
                        "too few numbers",
                        id,
                        "return new double[1];",
                        "wrong",
                        "the length of what it returns is 1, right is ",
                        "длина возвращённого массива\u00a0— 1, а нужна "),
                of(
                        "no numbers",
                        id,
                        "return new double[0];",
                        "wrong",
                        "the length of what it returns is 0, right is ",
                        "длина возвращённого массива\u00a0— 0, а нужна "),
                of(
                        "no numbers but NaN",
                        id,
                        "double[] all = new double[weights.length];"
                                + " java.util.Arrays.fill(all, Double.NaN); return all;",
                        "wrong",
                        "is NaN, right is ",
                        "NaN"),
                of(
                        "the array that it was given, changed",
                        id,
                        "weights[0] = 7; return weights;",
                        "wrong",
                        "it overwrites what it was only given to read",
                        "меняет то, что дано"),
                of(
                        "the arrays of a record, changed",
                        id,
                        "face.lamp()[0] = Double.NaN; return new double[weights.length];",
                        "wrong",
                        "it overwrites what it was only given to read",
                        "меняет то, что дано"));
    }

    static Stream<Arguments> segments() {
        return Stream.of(
                of(
                        "a segment of NaN",
                        "clip-segment",
                        "out.segment(Double.NaN, y0, x1, y1);",
                        "wrong",
                        "is NaN, right is ",
                        "NaN"),
                of(
                        "a segment to infinity",
                        "clip-segment",
                        "out.segment(x0, y0, Double.POSITIVE_INFINITY, y1);",
                        "wrong",
                        "is Infinity, right is ",
                        "Infinity"),
                of(
                        "a segment that begins at minus infinity",
                        "clip-segment",
                        "out.segment(Double.NEGATIVE_INFINITY, y0, x1, y1);",
                        "wrong",
                        "is -Infinity, right is ",
                        "-Infinity"),
                of(
                        "a segment to a giant number",
                        "clip-segment",
                        "out.segment(x0, y0, 1e300, y1);",
                        "wrong",
                        "1E+300",
                        "1E+300"),
                of(
                        "a segment to the least number above zero",
                        "clip-segment",
                        "out.segment(x0, y0, Double.MIN_VALUE, Double.MIN_VALUE);",
                        "wrong",
                        "E-324",
                        "E-324"),
                of(
                        "a sink of nobody",
                        "clip-segment",
                        "((SegmentSink) null).segment(x0, y0, x1, y1);",
                        "runtime_error",
                        "java.lang.NullPointerException",
                        "в строке 3"));
    }

    static Stream<Arguments> sides() {
        return Stream.of(
                of(
                        "no value within a value",
                        "point-in-triangle",
                        "Boolean none = null; return none;",
                        "runtime_error",
                        "java.lang.NullPointerException",
                        "в строке 3"));
    }
}
