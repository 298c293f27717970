package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;

class RunInputTest {
    private static final String[] ARGUMENTS = {"run", "line", "bresenham"};
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
                argumentSet(
                        "missing field is 0",
                        "{\"from\":[0,0]}",
                        "/to: missing; expected an array of 2 whole numbers"),
                argumentSet(
                        "unknown field is ignored",
                        "{\"form\":[0,0],\"to\":[1,1]}",
                        "/form: unknown field; allowed are from, to, window"),
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
                        "fraction is hidden by its exponent",
                        "{\"from\":[0,15e-1],\"to\":[1,1]}",
                        "/from/1: expected " + INT + ", got 15e-1"),
                argumentSet(
                        "exponent brings it above the range",
                        "{\"from\":[0,2147483648e0],\"to\":[1,1]}",
                        "/from/1: expected " + INT + ", got 2147483648e0"),
                argumentSet(
                        "exponent overflows",
                        "{\"from\":[0,1e1111111111111],\"to\":[1,1]}",
                        "/from/1: expected " + INT + ", got 1e1111111111111"),
                argumentSet(
                        "huge number is computed digit by digit",
                        "{\"from\":[0,1e2147483647],\"to\":[1,1]}",
                        "/from/1: expected " + INT + ", got 1e2147483647"),
                argumentSet(
                        "NaN is 0",
                        "{\"from\":[0,NaN],\"to\":[1,1]}",
                        "/from/1: expected " + INT + ", got NaN"),
                argumentSet(
                        "number longer than the library takes is a fault",
                        "{\"from\":[0,0],\"to\":[1," + "9".repeat(1001) + "]}",
                        "/to/1: expected "
                                + INT
                                + " in at most 1000 characters, got "
                                + "9".repeat(40)
                                + "…"),
                argumentSet(
                        "name longer than the library takes is a fault",
                        "{\"" + "k".repeat(60_000) + "\":[0,0],\"to\":[1,1]}",
                        "/" + "k".repeat(39) + "…: unknown field; allowed are from, to, window"),
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
                        "/from: only 1 value; expected an array of 2 whole numbers"),
                argumentSet(
                        "third coordinate is ignored",
                        "{\"from\":[7,8,9],\"to\":[1,1]}",
                        "/from: more than 2 values; expected an array of 2 whole numbers"),
                argumentSet(
                        "window's ends are swapped",
                        "{\"from\":[7,8],\"to\":[1,1],\"window\":[5,0,3,9]}",
                        "/window: xmin must be at most xmax, got 5 > 3"),
                argumentSet(
                        "window's rows are swapped",
                        "{\"from\":[7,8],\"to\":[1,1],\"window\":[0,9,3,1]}",
                        "/window: ymin must be at most ymax, got 9 > 1"));
    }

    @ParameterizedTest(name = "{0} is no whole number")
    @ValueSource(strings = {"1", "1.0", "1e0", "10E-1", "0.1e+1", "1.000000000000000000000000"})
    void takesANumberThatIsWholeHoweverItIsWritten(String one) {
        Ran ran = Ran.labReading("{\"from\":[" + one + ",0],\"to\":[1,0]}", ARGUMENTS);
        assertEquals("{\"pixels\":[[1,0]]}\n", ran.out());
        ran.assertDone();
    }

    @Test
    void refusedLineKeepsTheRestOfTheBatch() {
        String good = "{\"from\":[3,3],\"to\":[3,3]}";
        String bad = "{\"from\":[" + "9".repeat(1001) + ",0],\"to\":[1,1]}";
        Ran ran = Ran.labReading(bad + "\n" + good, "run", "line", "bresenham", "--lines");
        List<String> answers = ran.out().lines().toList();
        assertEquals("{\"pixels\":[[3,3]]}", answers.get(1), ran.out());
        assertTrue(answers.get(0).startsWith("{\"error\":\"/from/0: "), answers.get(0));
        ran.assertDone();
    }

    @Test
    void textLongerThanIsReadIsNoFault() {
        String json = "{\"from\":\"" + "t".repeat(1 << 21) + "\",\"to\":[1,1]}";
        Ran ran = Ran.labReading(json, ARGUMENTS);
        String said =
                ran.err()
                        .replaceFirst("column \\d+", "column N")
                        .replaceFirst("\\(\\d+\\)", "(L)")
                        .strip();
        assertEquals(
                "./lab run: line 1, column N: not JSON: String value length (L) exceeds the"
                        + " maximum allowed (1048576)",
                said);
        assertEquals(2, ran.exitCode());
    }

    private static final String OPEN = "the text ends here, but something in it is not closed";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("brokenJson")
    void saysInPlainWordsWhereJsonIsBroken(String json, String message) {
        Ran.labReading(json, ARGUMENTS).assertComplains(2, "./lab run: " + message);
    }

    static Stream<Arguments> brokenJson() {
        return Stream.of(
                argumentSet(
                        "text",
                        "hello\nworld",
                        "line 1, column 1: not JSON: expected "
                                + "a value: a text in double quotes, a number, {…}, […], true, false or null, got 'hello'"),
                argumentSet("object has no end", "{", "line 1, column 2: not JSON: " + OPEN),
                argumentSet(
                        "number has no end",
                        "{\"from\":[0,",
                        "line 1, column 12: not JSON: " + OPEN),
                argumentSet(
                        "second line is counted as the first",
                        "{\n\"from\" 3",
                        "line 2, column 8: not JSON: expected a colon after the field's name, got '3'"),
                argumentSet(
                        "wrong bracket",
                        "{\"to\":[1}",
                        "line 1, column 9: not JSON: Unexpected close marker '}': expected ']'"),
                argumentSet(
                        "comment",
                        "{/* */}",
                        "line 1, column 2: not JSON: expected a value, no comment, got '/'"),
                argumentSet(
                        "field's name without quotes",
                        "{ййййййййййй: 1}",
                        "line 1, column 3: not JSON: expected a field's name in double quotes, got 'й'"),
                argumentSet(
                        "depth",
                        "{\"from\":[" + "[".repeat(100_000),
                        "/from/0: expected " + INT + ", got an array"));
    }
}
