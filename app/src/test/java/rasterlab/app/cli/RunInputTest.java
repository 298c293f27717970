package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class RunInputTest {
    private static final String INT = "a whole number from -2147483648 to 2147483647";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesWithPlaceValueAndRange(String json, String message) {
        Ran.labReading(json, "run", "line", "bresenham")
                .assertComplains(2, "./lab run: " + message);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void answersThatLineWithTheError(String json, String message) {
        Ran ran = Ran.labReading(json + "\n", "run", "line", "bresenham", "--lines");
        String expected = message.replace("\"", "\\\"");
        if (json.isBlank()) expected = "the line is empty; expected a JSON object";
        assertEquals("{\"error\":\"" + expected + "\"}\n", ran.out());
        ran.assertDone();
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "empty input is taken for an object",
                        "",
                        "the input is empty; expected a JSON object with from, to"),
                argumentSet(
                        "another type than an object",
                        "[1,2]",
                        "/: expected a JSON object with from, to, got an array"),
                argumentSet("missing field is 0", "{\"from\":[0,0]}", "/to: missing"),
                argumentSet(
                        "unknown field is ignored",
                        "{\"form\":[0,0],\"to\":[1,1]}",
                        "/form: unknown field; allowed are [from, to, window]"),
                argumentSet(
                        "the last of two fields wins",
                        "{\"from\":[0,0],\"from\":[0,1],\"to\":[1,1]}",
                        "/from: the field is given twice"),
                argumentSet(
                        "what follows the object is ignored",
                        "{\"from\":[0,0],\"to\":[1,1]} 7",
                        "line 1, column 27: 7 follows the object; expected nothing more"),
                argumentSet(
                        "fraction is cut off",
                        "{\"from\":[0,1.5],\"to\":[1,1]}",
                        "/from/1: expected " + INT + ", got 1.5"),
                argumentSet(
                        "whole number written as a fraction",
                        "{\"from\":[0,1.0],\"to\":[1,1]}",
                        "/from/1: expected " + INT + ", got 1.0"),
                argumentSet(
                        "one above the range wraps round",
                        "{\"from\":[0,0],\"to\":[2147483648,1]}",
                        "/to/0: expected " + INT + ", got 2147483648"),
                argumentSet(
                        "long number fills the message",
                        "{\"from\":[0,0],\"to\":[1," + "9".repeat(500) + "]}",
                        "/to/1: expected " + INT + ", got " + "9".repeat(40) + "…"),
                argumentSet(
                        "number as a string",
                        "{\"from\":[\"0\",0],\"to\":[1,1]}",
                        "/from/0: expected " + INT + ", got the string \"0\""),
                argumentSet(
                        "null is 0",
                        "{\"from\":[null,0],\"to\":[1,1]}",
                        "/from/0: expected " + INT + ", got null"),
                argumentSet(
                        "point is no array",
                        "{\"from\":7,\"to\":[1,1]}",
                        "/from: expected an array of 2 whole numbers, got 7"),
                argumentSet(
                        "point has one coordinate",
                        "{\"from\":[7],\"to\":[1,1]}",
                        "/from: only 1 values; expected an array of 2 whole numbers"),
                argumentSet(
                        "third coordinate is ignored",
                        "{\"from\":[7,8,9],\"to\":[1,1]}",
                        "/from: more than 2 values; expected an array of 2 whole numbers"),
                argumentSet(
                        "window's ends are swapped",
                        "{\"from\":[7,8],\"to\":[1,1],\"window\":[5,0,3,9]}",
                        "/window: xmin 5 is greater than xmax 3"),
                argumentSet(
                        "window's rows are swapped",
                        "{\"from\":[7,8],\"to\":[1,1],\"window\":[0,9,3,1]}",
                        "/window: ymin 9 is greater than ymax 1"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("brokenJson")
    void saysWhereJsonIsBroken(String json, String start) {
        Ran ran = Ran.labReading(json, "run", "line", "bresenham");
        assertEquals("./lab run: " + start, firstOf(ran.err(), start.length() + 11));
        assertEquals(1, ran.err().lines().count());
        assertEquals("", ran.out());
        assertEquals(2, ran.exitCode());
    }

    private static String firstOf(String text, int length) {
        return text.substring(0, Math.min(length, text.length()));
    }

    static Stream<Arguments> brokenJson() {
        return Stream.of(
                argumentSet("text", "hello\nworld", "line 1, column 1: not JSON: "),
                argumentSet("unended", "{\"from\":[0,", "line 1, column 12: not JSON: "),
                argumentSet("second line", "{\n\"from\" 3", "line 2, column 8: not JSON: "),
                argumentSet("comment", "{/* */}", "line 1, column 2: not JSON: "),
                argumentSet(
                        "depth",
                        "{\"from\":[" + "[".repeat(100_000),
                        "/from/0: expected a whole number from "));
    }
}
