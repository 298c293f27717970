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

/** Runs {@code ./lab run} on lines with coverage, circles and ellipses. */
class RunRasterTest {
    @Test
    void wuSharesEachStepBetweenTwoPixels() {
        Ran ran = Ran.labReading("{\"from\":[0,0],\"to\":[2,1]}", "run", "line", "wu");
        assertEquals(
                "{\"pixels\":[[0,0],[1,0],[1,1],[2,1]],\"coverage\":[255,128,127,255]}\n",
                ran.out());
    }

    @Test
    void aWindowIsEnteredWithoutWalkingThere() {
        String in =
                "{\"from\":[-2147483648,-2147483647],\"to\":[2147483647,2147483647],"
                        + "\"window\":[5,0,7,9]}";
        Ran ran = Ran.labReading(in, "run", "line", "midpoint", "--steps");
        assertTrue(ran.out().startsWith("{\"pixels\":[[5,5],[6,6],[7,7]],"), ran.out());
        ran.assertDone();
    }

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
                        "a circle of one pixel",
                        "circle",
                        "midpoint",
                        "{\"center\":[3,4],\"radius\":0}",
                        "{\"pixels\":[[3,4]]}"),
                argumentSet(
                        "a circle of four pixels",
                        "circle",
                        "bresenham",
                        "{\"center\":[0,0],\"radius\":1}",
                        "{\"pixels\":[[0,1],[0,-1],[1,0],[-1,0]]}"),
                argumentSet(
                        "an ellipse that is a line",
                        "ellipse",
                        "midpoint",
                        "{\"center\":[0,0],\"rx\":1,\"ry\":0}",
                        "{\"pixels\":[[0,0],[1,0],[-1,0]]}"));
    }

    @Test
    void stepsOfACircleAreItsOctant() {
        Ran ran =
                Ran.labReading(
                        "{\"center\":[9,9],\"radius\":2}", "run", "circle", "midpoint", "--steps");
        assertTrue(
                ran.out()
                        .contains(
                                "\"steps\":[{\"u\":0,\"v\":2,\"decision\":-1.0},"
                                        + "{\"u\":1,\"v\":2,\"decision\":2.0}]"),
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
        return Stream.of(
                argumentSet(
                        "the radius is below 0",
                        "circle",
                        "midpoint",
                        "{\"center\":[0,0],\"radius\":-1}",
                        2,
                        "/radius: expected a whole number from 0 to 2147483647, got -1"),
                argumentSet(
                        "half an ellipse is below 0",
                        "ellipse",
                        "parametric",
                        "{\"center\":[0,0],\"rx\":-2,\"ry\":1}",
                        2,
                        "/rx: expected a whole number from 0 to 524288, got -2"),
                argumentSet(
                        "the eye is behind the origin",
                        "view",
                        "one-matrix",
                        "{\"points\":[],\"theta\":0,\"phi\":0,\"rho\":-1}",
                        2,
                        "/rho: expected a number above 0, up to 1.0715086071862673e301, got -1"),
                argumentSet(
                        "the circle has more pixels than an answer",
                        "circle",
                        "midpoint",
                        "{\"center\":[0,0],\"radius\":9999999}",
                        4,
                        "the answer has more than 10000000 pixels, the most that one answer may"
                                + " have; give a smaller \"radius\""),
                argumentSet(
                        "the circle leaves the range",
                        "circle",
                        "bresenham",
                        "{\"center\":[2147483647,0],\"radius\":1}",
                        3,
                        "bresenham refuses: centre 2147483647 ± radius 1 along x must lie in"
                                + " -2147483648..2147483647"),
                argumentSet(
                        "the ellipse is too large",
                        "ellipse",
                        "midpoint",
                        "{\"center\":[0,0],\"rx\":5,\"ry\":600000}",
                        2,
                        "/ry: expected a whole number from 0 to 524288, got 600000"),
                argumentSet(
                        "the radius is missing",
                        "circle",
                        "midpoint",
                        "{\"center\":[0,0]}",
                        2,
                        "/radius: missing; expected a whole number from 0 to 2147483647"),
                argumentSet(
                        "the radius is no number",
                        "ellipse",
                        "midpoint",
                        "{\"center\":[0,0],\"rx\":1,\"ry\":true}",
                        2,
                        "/ry: expected a whole number from 0 to 524288, got true"),
                argumentSet(
                        "a field is unknown",
                        "circle",
                        "parametric",
                        "{\"center\":[0,0],\"radius\":1,\"x\":2}",
                        2,
                        "/x: unknown field; allowed are center, radius"));
    }
}
