package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

/** Topics {@code fill} and {@code polygon-fill}. */
class RunFillTest {
    private static final String GAP =
            "{\"picture\":[\".#.\",\"#..\"],\"seed\":[0,0],\"with\":\"*\",\"connectivity\":";
    private static final String SQUARE =
            "{\"polygon\":[[0,0],[2,0],[2,2],[0,2]],\"rule\":\"evenodd\",\"size\":";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("answers")
    void answers(String topic, String method, String in, String out) {
        Ran ran = Ran.labReading(in, "run", topic, method);
        assertEquals(out + "\n", ran.out());
        ran.assertDone();
    }

    static Stream<Arguments> answers() {
        return Stream.of(
                argumentSet(
                        "four neighbours stay behind the gap",
                        "fill",
                        "span",
                        GAP + "4}",
                        "{\"picture\":[\"*#.\",\"#..\"]}"),
                argumentSet(
                        "eight neighbours pass the gap",
                        "fill",
                        "stack",
                        GAP + "8}",
                        "{\"picture\":[\"*#*\",\"#**\"]}"),
                argumentSet(
                        "a character beyond 16 bits is one pixel",
                        "fill",
                        "span",
                        "{\"picture\":[\"😀😀x\"],\"seed\":[1,0],\"with\":\"🙂\",\"connectivity\":4}",
                        "{\"picture\":[\"\\uD83D\\uDE42\\uD83D\\uDE42x\"]}"),
                argumentSet(
                        "right and bottom edges are not filled",
                        "polygon-fill",
                        "scanline",
                        SQUARE + "[9,9]}",
                        "{\"pixels\":[[0,0],[1,0],[0,1],[1,1]]}"),
                argumentSet(
                        "the picture cuts",
                        "polygon-fill",
                        "edge-function",
                        SQUARE + "[1,9]}",
                        "{\"pixels\":[[0,0],[0,1]]}"),
                argumentSet(
                        "no corners, no pixels",
                        "polygon-fill",
                        "scanline",
                        "{\"polygon\":[],\"rule\":\"nonzero\",\"size\":[4,4]}",
                        "{\"pixels\":[]}"));
    }

    @Test
    void stepsOfAFillAreItsRuns() {
        Ran ran = Ran.labReading(GAP + "4}", "run", "fill", "span", "--steps");
        assertTrue(
                ran.out().contains("\"steps\":[{\"y\":0,\"from\":0,\"to\":1,\"decision\":1}]"),
                ran.out());
    }

    @Test
    void stepsOfAPolygonAreItsSpans() {
        Ran ran = Ran.labReading(SQUARE + "[9,9]}", "run", "polygon-fill", "scanline", "--steps");
        assertTrue(
                ran.out()
                        .contains(
                                "\"steps\":[{\"y\":0,\"from\":0,\"to\":2,\"decision\":2},"
                                        + "{\"y\":1,\"from\":0,\"to\":2,\"decision\":2}]"),
                ran.out());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("refusals")
    void refuses(String topic, String method, String in, int exitCode, String message) {
        Ran ran = Ran.labReading(in, "run", topic, method);
        assertEquals("./lab run: " + message + "\n", ran.err());
        assertEquals("", ran.out());
        assertEquals(exitCode, ran.exitCode());
    }

    static Stream<Arguments> refusals() {
        String fill = "fill";
        String polygon = "polygon-fill";
        return Stream.of(
                argumentSet(
                        "seed beside the picture crashes",
                        fill,
                        "span",
                        "{\"picture\":[\"..\"],\"seed\":[2,0],\"with\":\"*\",\"connectivity\":4}",
                        2,
                        "/seed/0: expected a whole number from 0 to 1, got 2"),
                argumentSet(
                        "short row is read beyond its end",
                        fill,
                        "span",
                        "{\"picture\":[\"..\",\".\"],\"seed\":[0,0],\"with\":\"*\",\"connectivity\":4}",
                        2,
                        "/picture/1: expected 2 characters as /picture/0 has, got 1"),
                argumentSet(
                        "picture without rows",
                        fill,
                        "span",
                        "{\"picture\":[],\"seed\":[0,0],\"with\":\"*\",\"connectivity\":4}",
                        2,
                        "/picture: only 0 values; expected an array of 1 to 8192 rows"),
                argumentSet(
                        "two characters are one colour",
                        fill,
                        "span",
                        "{\"picture\":[\".\"],\"seed\":[0,0],\"with\":\"ab\",\"connectivity\":4}",
                        2,
                        "/with: expected one character, got ab"),
                argumentSet(
                        "half a character is written",
                        fill,
                        "span",
                        "{\"picture\":[\".\"],\"seed\":[0,0],\"with\":\"\\ud800\",\"connectivity\":4}",
                        2,
                        "/with: expected characters, got half of a surrogate pair"),
                argumentSet(
                        "a colour of three characters might have had two",
                        fill,
                        "span",
                        "{\"picture\":[\".\"],\"seed\":[0,0],\"with\":\"abc\",\"connectivity\":4}",
                        2,
                        "/with: expected a text of one character, got the string \"abc\""),
                argumentSet(
                        "a row may be twice as long as a picture",
                        fill,
                        "span",
                        "{\"picture\":[\"\"],\"seed\":[0,0],\"with\":\"*\",\"connectivity\":4}",
                        2,
                        "/picture/0: expected a text of 1 to 8192 characters, got the string \"\""),
                argumentSet(
                        "connectivity is taken for 4",
                        fill,
                        "span",
                        GAP + "6}",
                        2,
                        "/connectivity: expected 4 or 8, got 6"),
                argumentSet(
                        "rule is taken for one",
                        polygon,
                        "scanline",
                        "{\"polygon\":[],\"rule\":\"odd\",\"size\":[4,4]}",
                        2,
                        "/rule: expected one of evenodd, nonzero, got the string \"odd\""),
                argumentSet(
                        "picture without columns",
                        polygon,
                        "scanline",
                        SQUARE + "[0,4]}",
                        2,
                        "/size/0: expected a whole number from 1 to 8192, got 0"),
                argumentSet(
                        "coordinate whose products overflow",
                        polygon,
                        "scanline",
                        "{\"polygon\":[[0,0],[1e300,0],[0,1]],\"rule\":\"evenodd\",\"size\":[4,4]}",
                        3,
                        "scanline refuses: x of corner 1 must be a number from -1e100 to 1e100, got"
                                + " 1e300"),
                argumentSet(
                        "answer of 67 million pixels fills the memory",
                        polygon,
                        "scanline",
                        "{\"polygon\":[[0,0],[9e9,0],[0,9e9]],\"rule\":\"evenodd\",\"size\":[8192,8192]}",
                        4,
                        "the answer has more than 10000000 pixels, the most that one answer may"
                                + " have; give a smaller \"size\""));
    }

    /** The fill goes around a hole, with the colour that is there already. */
    @Test
    void endlessFillIsGivenUp() {
        Ran.labReading(
                        "{\"picture\":[\"...\",\".#.\",\"...\"],\"seed\":[0,0],\"with\":\".\","
                                + "\"connectivity\":4}",
                        "run",
                        "fill",
                        "recursive-textbook")
                .assertComplains(
                        4,
                        "./lab run: recursive-textbook does not end: it wrote more than 18 pixels,"
                                + " twice what the picture has");
    }
}
