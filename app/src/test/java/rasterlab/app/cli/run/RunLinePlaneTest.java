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

/** Topic line-plane by {@code ./lab run}. */
class RunLinePlaneTest {
    private static final String LEVEL = "\"normal\":[0,0,2],\"point\":[7,7,4]";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("answers")
    void answers(String method, String json, String answer) {
        Ran ran = Ran.labReading(json, "run", "line-plane", method);
        assertEquals(answer + "\n", ran.out());
        ran.assertDone();
    }

    static Stream<Arguments> answers() {
        return Stream.of(
                argumentSet(
                        "point beyond the second is between",
                        "formula",
                        "{\"line\":[[1,1,0],[1,1,1]]," + LEVEL + "}",
                        "{\"mu\":4.0,\"point\":[1.0,1.0,4.0],\"part\":\"beyond\",\"angle\":90.0,"
                                + "\"cosines\":[0.0,0.0,1.0],\"projection\":1.0}"),
                argumentSet(
                        "three points are no plane",
                        "unrounded",
                        "{\"line\":[[0,0,2],[0,0,0]],\"plane\":[[0,0,1],[1,0,1],[0,1,1]]}",
                        "{\"mu\":0.5,\"point\":[0.0,0.0,1.0],\"part\":\"between\",\"angle\":90.0,"
                                + "\"cosines\":[0.0,0.0,-1.0],\"projection\":-2.0}"),
                argumentSet(
                        "textbook names a point of a parallel line",
                        "formula-textbook",
                        "{\"line\":[[0,0,1],[1,0,1]]," + LEVEL + "}",
                        "{\"mu\":null,\"angle\":0.0,\"cosines\":[1.0,0.0,0.0],"
                                + "\"projection\":0.0}"));
    }

    @Test
    void aPointFarBeyondTheLinesEndsLosesNoDigits() {
        Ran ran =
                Ran.labReading(
                        "{\"line\":[[1,2,3],[1.0000000000000002,2.0000000000000004,3]],"
                                + "\"normal\":[0.1,0.3,0.7],\"point\":[5.3,10.6,3]}",
                        "run",
                        "line-plane",
                        "unrounded");
        ran.assertDone();
        assertTrue(ran.out().contains("\"point\":[5.3,10.6,3.0]"), ran.out());
    }

    @Test
    void aPlaneWhoseDistanceIsBeyondTheDoublesIsMet() {
        Ran ran =
                Ran.labReading(
                        "{\"line\":[[0,0,0],[20,2,0]],"
                                + "\"normal\":[1e308,1e308,0],\"point\":[10,1,1]}",
                        "run",
                        "line-plane",
                        "unrounded");
        ran.assertDone();
        assertTrue(ran.out().contains("\"mu\":0.5"), ran.out() + ran.err());
    }

    @Test
    void aPointBeyondTheDoublesLeavesNoHalfAnswer() {
        String far = "{\"line\":[[0,0,0],[1.7976931348623157e308,1,1]]," + LEVEL + "}";
        Ran ran = Ran.labReading(far, "run", "line-plane", "formula-textbook");
        assertEquals(3, ran.exitCode(), ran.err());
        assertEquals("", ran.out());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(int code, String json, String message) {
        Ran.labReading(json, "run", "line-plane", "formula")
                .assertComplains(code, "./lab run: " + message);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "parallel line meets the plane",
                        3,
                        "{\"line\":[[0,0,1],[1,0,1]]," + LEVEL + "}",
                        "formula refuses: line must not be parallel to the plane, but n·p* is"
                                + " 0"),
                argumentSet(
                        "normal without a point is a plane",
                        2,
                        "{\"line\":[[0,0,1],[1,0,2]],\"normal\":[0,0,1]}",
                        "/: expected either plane, or normal and point, got line, normal"),
                argumentSet(
                        "one point twice is a line",
                        2,
                        "{\"line\":[[1,2,3],[1,2,3]]," + LEVEL + "}",
                        "/line: a line needs two different points, got (1, 2, 3)" + " twice"),
                argumentSet(
                        "normal of no length has a direction",
                        2,
                        "{\"line\":[[0,0,1],[1,0,2]],\"normal\":[0,0,0],\"point\":[1,1,1]}",
                        "/normal: must not be zero, got (0, 0, 0)"));
    }
}
